// SPDX-License-Identifier: BSD-3-Clause
#include "graph/graph_view.h"

#include <gtest/gtest.h>

#include <atomic>

#include "boxplus/boxplus.h"
#include "boxplus/types/slam3d/plane.h"

namespace boxplus {
namespace {

TEST(EdgeRoles, ThePoseOfASensorIsNoPoseOfTheTrajectory) {
  Graph graph;
  const auto sensor = graph.add_vertex(SE3(), 0);
  const auto a = graph.add_vertex(SE3(), 1), b = graph.add_vertex(SE3(), 2), c = graph.add_vertex(SE3(), 3);
  const auto plane = graph.add_vertex(Plane3(), 4);
  const EdgeRef odometry = graph.add_edge(Between(SE3()), a, b);
  const EdgeRef closure = graph.add_edge(Between(SE3()), a, c);
  const EdgeRef seen = graph.add_edge(PlaneObservation3(Plane3()), b, plane, sensor);
  const EdgeRef seen_without_sensor = graph.add_edge(PlaneObservation3(Plane3()), b, plane);
  const EdgeRoles role(graph);
  EXPECT_EQ(role(odometry), EdgeRole::kOdometry);
  EXPECT_EQ(role(closure), EdgeRole::kLoopClosure);
  EXPECT_EQ(role(seen), EdgeRole::kObservation);
  EXPECT_EQ(role(seen_without_sensor), EdgeRole::kObservation);
}

TEST(EdgeRoles, APoseThatIsAlsoMeasuredDirectlyIsAPoseOfTheTrajectory) {
  Graph graph;
  const auto a = graph.add_vertex(SE3(), 1), b = graph.add_vertex(SE3(), 2);
  const auto plane = graph.add_vertex(Plane3(), 4);
  graph.add_edge(PlaneObservation3(Plane3()), a, plane, b);
  const EdgeRef between = graph.add_edge(Between(SE3()), a, b);
  EXPECT_EQ(EdgeRoles(graph)(between), EdgeRole::kOdometry);
}

TEST(EdgeRoles, OfALargeGraphEndIfTheTokenIsRaised) {
  Graph graph;
  for (int k = 0; k < 3000; ++k) graph.add_vertex(SE2(k, 0, 0));
  const std::atomic<bool> flag = true;
  EXPECT_THROW(EdgeRoles(graph, StopToken(&flag)), Stopped);
  EXPECT_EQ(EdgeRoles(graph).trajectory().size(), 3000U);
}

}  // namespace
}  // namespace boxplus
