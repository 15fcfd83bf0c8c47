// SPDX-License-Identifier: BSD-3-Clause
#include "certify/search.h"

#include <gtest/gtest.h>

#include <cmath>

#include "optimize/small_graphs.h"

namespace boxplus::certificate {
namespace {

constexpr double kTolerance = 1e-6;

ChordalProblem problem_of(const Graph& graph) {
  ChordalProblem problem;
  std::string complaint;
  EXPECT_TRUE(read_problem(graph, {}, problem, complaint)) << complaint;
  return problem;
}

/// A circle on which the headings make one turn too many.
Graph wound_circle(int count) {
  Graph graph;
  const auto poses = add_noisy_circle(graph, count);
  for (int k = 0; k < count; ++k) {
    const auto pose = poses[static_cast<std::size_t>(k)];
    const SE2 x = graph.estimate(pose);
    graph.set_estimate(pose, SE2(x.x(), x.y(), x.theta() + 2 * kPi * k / count));
  }
  return graph;
}

/// Moves every pose by about `distance`.
StackedPoses perturbed(StackedPoses poses, double distance) {
  std::mt19937 random(3);
  std::uniform_real_distribution<> uniform(-distance, distance);
  for (StackedPose& pose : poses) {
    for (double& value : pose.reshaped()) value += uniform(random);
    orthonormalize(pose);
  }
  return poses;
}

TEST(Search, ClimbsTheStaircaseOutOfALocalMinimum) {
  const Graph graph = wound_circle(30);
  const ChordalProblem problem = problem_of(graph);
  Search stuck(problem, read_poses(graph, problem), kTolerance, {});
  stuck.run(0);
  EXPECT_FALSE(stuck.is_global());
  EXPECT_FALSE(stuck.bound().has_value());
  Search search(problem, read_poses(graph, problem), kTolerance, {});
  search.run(3);
  EXPECT_TRUE(search.is_global());
  EXPECT_GT(search.escapes(), 0);
  EXPECT_LT(search.cost(), stuck.cost() / 10);
}

TEST(Search, PrefersTheOtherStartToTheStaircase) {
  const Graph graph = wound_circle(30);
  Graph unwound;
  add_noisy_circle(unwound, 30);
  const ChordalProblem problem = problem_of(graph);
  Search search(problem, read_poses(graph, problem), kTolerance, {});
  search.run(1, [&] { return read_poses(unwound, problem); });
  EXPECT_TRUE(search.is_global());
}

TEST(DualMatrix, GivesALowerBoundAwayFromTheMinimum) {
  Graph graph;
  add_noisy_grid(graph, 3);
  const ChordalProblem problem = problem_of(graph);
  Search search(problem, read_poses(graph, problem), kTolerance, {});
  search.run(0);
  ASSERT_TRUE(search.is_global());
  DualMatrix dual(problem, {});
  for (const double distance : {1e-4, 1e-3, 1e-2}) {
    const StackedPoses poses = perturbed(search.poses(), distance);
    dual.update(poses);
    const auto gap = dual.gap(0);
    ASSERT_TRUE(gap.has_value()) << distance;
    const double excess = problem.cost(poses) - search.cost();
    EXPECT_GE(*gap, excess * (1 - 1e-6)) << distance;
    EXPECT_GT(excess, 0);
  }
}

TEST(DualMatrix, HasNoBoundAtALocalMinimumButADirectionOfNegativeCurvature) {
  const Graph graph = wound_circle(30);
  const ChordalProblem problem = problem_of(graph);
  StackedPoses poses = read_poses(graph, problem);
  DualMatrix dual(problem, {});
  RiemannianNewton(problem, dual, 2, {}).minimize(poses, 1e-12, 100);
  EXPECT_FALSE(dual.gap(kTolerance * problem.cost(poses)).has_value());
  const auto v = dual.negative_direction();
  ASSERT_TRUE(v.has_value());
  std::vector<double> product(v->size());
  double curvature = 0;
  const BlockStructure& s = dual.structure();
  for (std::uint32_t j = 0; j < s.blocks(); ++j) {
    for (std::uint32_t k = s.column_start[j]; k < s.column_start[j + 1]; ++k) {
      const Eigen::Map<const Eigen::Vector3d> row(v->data() + s.offset[s.row[k]]),
          column(v->data() + s.offset[j]);
      curvature += (s.row[k] == j ? 1 : 2) * row.dot(dual.block(j, k) * column);
    }
  }
  EXPECT_LT(curvature, 0);
}

TEST(RiemannianNewton, EndsAtAStationaryPointOfAnyRank) {
  Graph graph;
  add_noisy_grid(graph, 3);
  const ChordalProblem problem = problem_of(graph);
  for (const int rank : {3, 4, 5}) {
    StackedPoses poses = read_poses(graph, problem);
    for (StackedPose& pose : poses) {
      pose.conservativeResize(Eigen::NoChange, rank);
      pose.rightCols(rank - 3).setZero();
    }
    poses = perturbed(std::move(poses), 0.1);
    const double before = problem.cost(poses);
    DualMatrix dual(problem, {});
    RiemannianNewton(problem, dual, rank, {}).minimize(poses, 1e-12, 100);
    EXPECT_LT(problem.cost(poses), before);
    for (const std::uint32_t pose : problem.moving) {
      EXPECT_LT(dual.residual(pose).norm(), 1e-4 * problem.cost(poses)) << rank;
      const Eigen::MatrixXd rows = poses[pose].topRows(3);
      EXPECT_TRUE((rows * rows.transpose()).isIdentity(1e-12));
    }
  }
}

}  // namespace
}  // namespace boxplus::certificate
