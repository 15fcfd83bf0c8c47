// SPDX-License-Identifier: BSD-3-Clause
// Graph::weight() and Graph::jacobian() of one edge.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "boxplus/graph/graph.h"
#include "boxplus/manifold/rn.h"
#include "boxplus/robust/huber.h"
#include "boxplus/robust/robust_kernel.h"
#include "boxplus/types/slam2d.h"

namespace boxplus {
namespace {

constexpr auto kDifference = [](const auto& x, const auto& y) { return y - x; };

TEST(EdgeWeight, IsTheDerivativeOfTheKernelAtTheCurrentChi2) {
  Graph graph;
  const auto a = graph.add_vertex(0.0), b = graph.add_vertex(4.0);
  const auto edge = graph.add_edge(kDifference, 0.25, a, b);
  EXPECT_EQ(graph.weight(edge), 1);
  graph.set_kernel(edge, Huber(1));
  EXPECT_DOUBLE_EQ(graph.weight(edge), 0.5);  // delta / sqrt(chi2) with chi2 = 4
  graph.set_estimate(b, 1.0);
  EXPECT_EQ(graph.weight(edge), 1);
}

TEST(EdgeWeight, OfADisabledEdgeIsZero) {
  Graph graph;
  const auto a = graph.add_vertex(0.0), b = graph.add_vertex(4.0);
  const auto edge = graph.add_edge(kDifference, a, b);
  graph.set_enabled(edge, false);
  EXPECT_EQ(graph.weight(edge), 0);
}

/// A kernel that decreases for large chi2, so its derivative is negative there.
struct Falling final : RobustKernel {
  std::string_view name() const override { return "Falling"; }
  Rho operator()(double s) const override { return {s * (1 - s), 1 - 2 * s, -2}; }
  double delta() const override { return 1; }
  std::unique_ptr<RobustKernel> clone() const override { return std::make_unique<Falling>(); }
};

TEST(EdgeWeight, IsNeverNegative) {
  Graph graph;
  const auto a = graph.add_vertex(0.0), b = graph.add_vertex(4.0);
  const auto edge = graph.add_edge(kDifference, a, b);
  graph.set_kernel(edge, Falling());
  EXPECT_EQ(graph.weight(edge), 0);
}

TEST(EdgeJacobian, HasOneBlockPerVertexWithOneRowPerRowOfTheError) {
  Graph graph;
  const auto pose = graph.add_vertex(SE2(1, 2, 0.5));
  const auto point = graph.add_vertex(Vector2(3, 5));
  graph.fix(pose);
  const auto edge =
      graph.add_edge([](const auto& x, const auto& p) { return (x.rotation() * p + x.translation()).eval(); },
                     7.0, pose, point);
  graph.set_kernel(edge, Huber(0.1));
  const std::vector<Eigen::MatrixXd> J = graph.jacobian(edge);
  ASSERT_EQ(J.size(), 2u);
  const Eigen::Matrix2d R = graph.estimate(pose).rotation();
  Eigen::MatrixXd of_pose(2, 3);
  of_pose << R, R * Eigen::Vector2d(-5, 3);
  EXPECT_TRUE(J[0].isApprox(of_pose, 1e-14)) << J[0];
  EXPECT_TRUE(J[1].isApprox(R, 1e-14)) << J[1];
}

TEST(EdgeJacobian, OfARangeHasOneBlockPerVertex) {
  Graph graph;
  const std::vector tail{graph.add_vertex(1.0), graph.add_vertex(2.0), graph.add_vertex(3.0)};
  const auto edge = graph.add_edge(
      [](const auto& x) {
        auto sum = 0.0 * x[0];
        for (std::size_t i = 0; i < x.size(); ++i) sum += static_cast<double>(i + 1) * x[i];
        return sum;
      },
      tail);
  const std::vector<Eigen::MatrixXd> J = graph.jacobian(edge);
  ASSERT_EQ(J.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_EQ(J[i].size(), 1);
    EXPECT_DOUBLE_EQ(J[i](0, 0), static_cast<double>(i + 1));
  }
}

TEST(EdgeJacobian, OfABetweenEdgeAgreesWithFiniteDifferences) {
  Graph graph;
  const auto a = graph.add_vertex(SE2(1, 2, 0.5)), b = graph.add_vertex(SE2(3, -1, 1.5));
  const auto edge = graph.add_edge(Between(SE2(1, 0, 1)), a, b);
  const std::vector<Eigen::MatrixXd> J = graph.jacobian(edge);
  const std::vector<double> before = graph.error(edge);
  constexpr double kStep = 1e-6;
  for (int column = 0; column < 3; ++column) {
    double delta[3] = {};
    delta[column] = kStep;
    const SE2 kept = graph.estimate(b);
    graph.set_estimate(b, Manifold<SE2>::oplus(kept, delta));
    const std::vector<double> after = graph.error(edge);
    graph.set_estimate(b, kept);
    for (int row = 0; row < 3; ++row) {
      const auto r = static_cast<std::size_t>(row);
      EXPECT_NEAR(J[1](row, column), (after[r] - before[r]) / kStep, 1e-5);
    }
  }
}

}  // namespace
}  // namespace boxplus
