// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "boxplus/incremental/smoother.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/testing/simulate.h"
#include "boxplus/types/slam2d.h"
#include "boxplus/types/slam3d.h"
#include "incremental/drive.h"

namespace boxplus {
namespace {

struct Failing {
  bool* fails;
  Vector<double, 1> error(const SE2& x) const {
    if (*fails) throw std::runtime_error("the sensor failed");
    return Vector<double, 1>(x.translation()[0] - 3);
  }
};

TEST(Smoother, WorksAgainAfterAnErrorFunctionHasThrown) {
  Drive drive(4);
  drive.graph.fix(drive.poses()[0]);
  Smoother smoother(drive.graph);
  for (int k = 0; k < 20; ++k) drive.step();
  smoother.finish();
  bool fails = true;
  drive.graph.add_edge(Failing{&fails}, 1.0, drive.poses()[9]);
  const Graph before = drive.graph;
  for (int k = 0; k < 3; ++k) EXPECT_THROW(smoother.update(), std::runtime_error);
  for (const auto& pose : drive.poses())
    EXPECT_EQ(before.estimate(pose).translation(), drive.graph.estimate(pose).translation());
  fails = false;
  EXPECT_TRUE(smoother.finish().converged());
  EXPECT_LT(distance_from_batch(drive.graph), 1e-6);
}

TEST(Smoother, LeavesTheEstimatesAsTheyWereIfAnErrorIsNotFinite) {
  Drive drive(5);
  drive.graph.fix(drive.poses()[0]);
  Smoother smoother(drive.graph);
  for (int k = 0; k < 20; ++k) drive.step();
  smoother.finish();
  const auto bad = drive.graph.add_edge(Between(SE2(std::numeric_limits<double>::quiet_NaN(), 0, 0)), 1.0,
                                        drive.poses()[3], drive.poses()[9]);
  const Graph before = drive.graph;
  const SmootherReport report = smoother.update();
  EXPECT_EQ(report.reason, SmootherReport::Reason::kNonFinite);
  EXPECT_NE(report.message.find("vertex 3"), std::string::npos) << report.message;
  for (const auto& pose : drive.poses())
    EXPECT_EQ(before.estimate(pose).translation(), drive.graph.estimate(pose).translation());
  drive.graph.remove(bad);
  EXPECT_TRUE(smoother.finish().converged());
}

TEST(Smoother, StartsOverIfStepsDiverge) {
  Simulation world = simulate(World::kSphere, {.poses = 300});
  Graph& graph = world.graph;
  for (const VertexRef& vertex : graph.all_vertices()) {
    if (!graph.is_fixed(vertex)) graph.set_estimate(graph.typed<SE3>(vertex), SE3());
  }
  Smoother smoother(graph);
  const SmootherReport report = smoother.finish();
  EXPECT_TRUE(report.converged()) << report.message;
  Graph truth = world.truth;
  EXPECT_TRUE(optimize(truth).converged());
  EXPECT_NEAR(graph.chi2(), truth.chi2(), 1e-6 * truth.chi2());
}

TEST(Smoother, GoesOnInTheNextUpdateAfterALimit) {
  const Simulation world = simulate(World::kManhattan, {.poses = 400});
  Graph graph = world.graph;
  Smoother smoother(graph, {.relinearize = {1e-3, 1e-3, 1e-3}, .max_iterations = 1});
  SmootherReport report = smoother.update();
  EXPECT_EQ(report.reason, SmootherReport::Reason::kMaxIterations);
  int updates = 1;
  for (; !report.converged() && updates < 30; ++updates) {
    report = smoother.update();
    EXPECT_EQ(report.iterations, 1);
  }
  EXPECT_TRUE(report.converged());
  EXPECT_GT(updates, 2);
  smoother.finish();
  EXPECT_LT(distance_from_batch(graph), 1e-6);
}

TEST(Smoother, RefusesASecondSmootherAndAGraphThatIsGone) {
  auto graph = std::make_unique<Graph>();
  Smoother smoother(*graph);
  EXPECT_THROW(Smoother{*graph}, InvalidArgument);
  Smoother moved = std::move(smoother);
  EXPECT_NO_THROW(moved.update());
  graph.reset();
  EXPECT_THROW(moved.update(), InvalidArgument);
  Graph other;
  { const Smoother first(other); }
  EXPECT_NO_THROW(Smoother{other});
}

TEST(Smoother, KeepsToABudgetOfOperationsAndGoesOnInTheNextUpdate) {
  const Simulation world = simulate(World::kManhattan, {.poses = 400});
  Graph graph = world.graph, free = world.graph;
  constexpr double kBudget = 3e4;
  Smoother smoother(graph, {.relinearize = {1e-3, 1e-3, 1e-3}, .max_flops = kBudget});
  SmootherReport report = smoother.update();
  EXPECT_EQ(report.reason, SmootherReport::Reason::kMaxFlops);
  int updates = 1;
  for (; !report.converged() && updates < 2000; ++updates) report = smoother.update();
  EXPECT_TRUE(report.converged());
  EXPECT_GT(updates, 5);
  EXPECT_TRUE(smoother.finish().converged());
  EXPECT_LT(distance_from_batch(graph), 1e-6);
}

TEST(Smoother, RefusesWrongOptionsBoundsAndConstraints) {
  Drive drive(1);
  EXPECT_THROW(Smoother(drive.graph, {.max_iterations = 0}), InvalidArgument);
  EXPECT_THROW(Smoother(drive.graph, {.relinearize = {0, 1, 1}}), InvalidArgument);
  EXPECT_THROW(Smoother(drive.graph, {.sets_outliers_aside = true, .lag = 5}), InvalidArgument);
  Smoother smoother(drive.graph);
  EXPECT_THROW(smoother.set_options({.max_flops = -1}), InvalidArgument);
  drive.step();
  EXPECT_TRUE(smoother.update().converged());
  EXPECT_THROW(smoother.set_time(drive.poses()[0], std::nan("")), InvalidArgument);
  const auto point = drive.graph.add_vertex(Vector2(1, 1));
  drive.graph.add_edge(PointObservation2(Vector2(1, 1)), 1.0, drive.poses()[0], point);
  EXPECT_TRUE(smoother.update().converged());
  drive.graph.set_bounds(point, 0, 0.0, 0.5);
  EXPECT_THROW(smoother.update(), InvalidArgument);
  drive.graph.set_bounds(point, 0, -std::numeric_limits<double>::infinity(),
                         std::numeric_limits<double>::infinity());
  EXPECT_TRUE(smoother.update().converged());
}

}  // namespace
}  // namespace boxplus
