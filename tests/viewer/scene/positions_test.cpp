// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/scene/positions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "boxplus/manifold/se2.h"
#include "boxplus/manifold/se3.h"

namespace boxplus::viewer {
namespace {

using testing::ElementsAre;
using testing::FloatNear;
using testing::IsNan;
using testing::SizeIs;

TEST(Positions, AreRelativeToTheCenter) {
  Graph graph;
  graph.add_vertex(SE2(500001, 2, 0));
  graph.add_vertex(SE2(500002, 2, std::numbers::pi / 2));
  graph.add_vertex(SE2(500003, 5, 0));
  const Structure structure = make_structure(graph);
  EXPECT_THAT(structure.center, ElementsAre(500002, 2, 0));
  const Positions positions = read_positions(graph, structure);
  EXPECT_THAT(positions.points, ElementsAre(-1, 0, 0, 0, 0, 0, 1, 3, 0));
  ASSERT_THAT(positions.orientations, SizeIs(12));
  EXPECT_THAT(positions.orientations[6], FloatNear(std::sqrt(0.5F), 1e-6F));
  EXPECT_THAT(positions.orientations[7], FloatNear(std::sqrt(0.5F), 1e-6F));
}

TEST(Positions, HaveTheQuaternionsOfPosesInSpace) {
  Graph graph;
  const SE3 pose(Vector3(1, 2, 3), SO3::from_rotation_vector(Vector3(0.3, -0.2, 0.9)));
  graph.add_vertex(pose);
  const Positions positions = read_positions(graph, make_structure(graph));
  const Eigen::Quaterniond q(pose.rotation().matrix());
  EXPECT_THAT(
      positions.orientations,
      ElementsAre(FloatNear(static_cast<float>(q.x()), 1e-6F), FloatNear(static_cast<float>(q.y()), 1e-6F),
                  FloatNear(static_cast<float>(q.z()), 1e-6F), FloatNear(static_cast<float>(q.w()), 1e-6F)));
}

TEST(Positions, ThatCannotBeDrawnAreNotNumbers) {
  Graph graph;
  graph.add_vertex(SE2(1, 2, 0));
  graph.add_vertex(SE2(1, 3, 0));
  graph.add_vertex(SE2(1, 1e31, 0));
  const Positions positions = read_positions(graph, make_structure(graph));
  EXPECT_THAT(positions.points[6], IsNan());
  EXPECT_THAT(positions.points[7], IsNan());
  EXPECT_THAT(positions.points[8], IsNan());
  EXPECT_FALSE(std::isnan(positions.points[0]));
}

}  // namespace
}  // namespace boxplus::viewer
