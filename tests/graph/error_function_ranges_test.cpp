// SPDX-License-Identifier: BSD-3-Clause
// Edges over several ranges of vertices of different types, and analytic Jacobians of run-time size.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <numeric>

#include "boxplus/graph/graph.h"
#include "boxplus/manifold/rn.h"
#include "boxplus/manifold/se2.h"
#include "boxplus/testing/check_jacobians.h"

namespace boxplus {
namespace {

using testing::ElementsAre;

/// Has one row per point p: the first coordinate of pose⁻¹ p, multiplied by the sum of all scales. The
/// function is a template, so boxplus differentiates it automatically.
struct Stack {
  template <class S, class Point, class Scale>
  Vector<S, kDynamic> error(const BasicSE2<S>& pose, std::span<const Point> points,
                            std::span<const Scale> scales) const {
    S sum(0.0);
    for (const auto& scale : scales) sum += scale;
    Vector<S, kDynamic> e(static_cast<Eigen::Index>(points.size()));
    for (std::size_t k = 0; k < points.size(); ++k)
      e[static_cast<Eigen::Index>(k)] = sum * pose.inverse_times(points[k])[0];
    return e;
  }
};

struct StackWithJacobians : Stack {
  template <class JPose, class JPoints, class JScales>
  void jacobians(const SE2& pose, std::span<const Vector2> points, std::span<const double> scales,
                 JPose& J_pose, JPoints& J_points, JScales& J_scales) const {
    const double sum = std::accumulate(scales.begin(), scales.end(), 0.0);
    const auto R = pose.rotation();
    J_points.setZero();
    for (Eigen::Index k = 0; k < J_points.rows(); ++k) {
      const Vector2 local = pose.inverse_times(points[static_cast<std::size_t>(k)]);
      J_pose.row(k) << -sum, 0, sum * local[1];
      J_points.template block<1, 2>(k, 2 * k) = sum * R.col(0).transpose();
      J_scales.row(k).setConstant(local[0]);
    }
  }
};

struct World {
  Graph graph;
  VertexHandle<SE2> pose = graph.add_vertex(SE2(1, 2, 0.3));
  std::vector<VertexHandle<Vector2>> points;
  std::vector<VertexHandle<double>> scales;

  World() {
    for (int k = 0; k < 4; ++k) points.push_back(graph.add_vertex(Vector2(k, 3 - k)));
    for (const double scale : {2.0, 0.5}) scales.push_back(graph.add_vertex(scale));
  }
};

TEST(SeveralRanges, ReachTheErrorFunctionInTheOrderOfTheArguments) {
  World w;
  const auto edge = w.graph.add_edge(
      [](std::span<const double> a, std::span<const Vector2> b) {
        return std::array{a[0] - a[1], b[0][0] + b[1][1], static_cast<double>(10 * a.size() + b.size())};
      },
      std::vector{w.scales[1], w.scales[0]}, std::vector{w.points[3], w.points[1]});
  EXPECT_THAT(w.graph.error(edge), ElementsAre(-1.5, 3 + 2, 22));
  EXPECT_THAT(w.graph.vertices(edge), ElementsAre(VertexRef(w.scales[1]), VertexRef(w.scales[0]),
                                                  VertexRef(w.points[3]), VertexRef(w.points[1])));
  EXPECT_THAT(w.graph.edges(w.points[1]), ElementsAre(EdgeRef(edge)));
}

/// The sum of the range. Before it reads the range, it evaluates another edge of the same type.
struct SumAfterAnother {
  const Graph* graph = nullptr;
  EdgeRef other = {};
  template <class S>
  S error(std::span<const S> x) const {
    if (graph != nullptr) {
      (void)graph->chi2(other);
      (void)graph->jacobian(other);
    }
    return std::accumulate(x.begin(), x.end(), S(0.0));
  }
};

TEST(Ranges, StayTheSameWhileTheErrorFunctionEvaluatesAnotherEdgeOfItsType) {
  Graph graph;
  std::vector<VertexHandle<double>> small, large;
  for (int k = 0; k < 3; ++k) small.push_back(graph.add_vertex(1.0));
  for (int k = 0; k < 7; ++k) large.push_back(graph.add_vertex(100.0));
  const auto inner = graph.add_edge(SumAfterAnother{}, large);
  const auto middle = graph.add_edge(SumAfterAnother{&graph, inner}, small);
  const auto outer = graph.add_edge(SumAfterAnother{&graph, middle}, small);
  for (const EdgeRef edge : {middle, outer}) {
    EXPECT_EQ(graph.chi2(edge), 9);
    for (const Eigen::MatrixXd& J : graph.jacobian(edge)) EXPECT_EQ(J, Eigen::MatrixXd::Ones(1, 1));
  }
}

TEST(SeveralRanges, HaveExactJacobiansForEachVertexOfEachRange) {
  World w;
  const auto edge = w.graph.add_edge(Stack{}, w.pose, w.points, w.scales);
  const auto own = w.graph.add_edge(StackWithJacobians{}, w.pose, w.points, w.scales);
  EXPECT_EQ(w.graph.edge_pools()[edge.pool]->jacobian_source(), detail::JacobianSource::kAutomatic);
  EXPECT_EQ(w.graph.edge_pools()[own.pool]->jacobian_source(), detail::JacobianSource::kAnalytic);
  const auto exact = w.graph.jacobian(edge), analytic = w.graph.jacobian(own);
  ASSERT_EQ(exact.size(), 7u);
  for (std::size_t k = 0; k < 7; ++k) EXPECT_LE((exact[k] - analytic[k]).norm(), 1e-13) << k;
  EXPECT_EQ(exact[2].col(0).cwiseAbs().array().count(), 1);  // the second point affects only the second row
}

TEST(SeveralRanges, AreAcceptedByCheckJacobians) {
  const std::vector<Vector2> points{Vector2(1, 2), Vector2(3, 1)};
  const JacobianCheck check =
      check_jacobians(StackWithJacobians{}, SE2(1, 2, 0.3), points, std::vector<double>{2, 0.5, 1});
  EXPECT_TRUE(check.ok) << check.message;
}

TEST(SeveralRanges, MayBeEmptyAndMayDifferInLengthFromTheRangesOfARemovedEdge) {
  World w;
  const auto error = [](std::span<const Vector2> b, std::span<const double> a) {
    double sum = 0;
    for (const Vector2& point : b) sum += 100 * point[0];
    for (const double x : a) sum += x;
    return sum;
  };
  const std::vector<VertexHandle<Vector2>> none;
  const std::vector two_points{w.points[1], w.points[2]};
  const auto first = w.graph.add_edge(error, none, w.scales);
  EXPECT_THAT(w.graph.error(first), ElementsAre(2.5));
  w.graph.remove(first);
  const auto second = w.graph.add_edge(error, two_points, std::vector<VertexHandle<double>>());
  EXPECT_EQ(second.slot, first.slot);
  EXPECT_THAT(w.graph.error(second), ElementsAre(300));
  EXPECT_THAT(w.graph.vertices(second), ElementsAre(VertexRef(w.points[1]), VertexRef(w.points[2])));
  // scales[1] has the same slot number as points[1], but it is in another pool. If scales[1] is removed, the
  // edge must stay, because it connects points[1] and not scales[1].
  w.graph.remove(w.scales[1]);
  EXPECT_TRUE(w.graph.contains(second));
  w.graph.remove(w.points[2]);
  EXPECT_FALSE(w.graph.contains(second));
}

TEST(SeveralRanges, AreCopiedWithTheirGraph) {
  World w;
  const auto edge = w.graph.add_edge(Stack{}, w.pose, w.points, w.scales);
  const Graph copy = w.graph;
  w.graph.set_estimate(w.scales[0], 100.0);
  w.graph.set_estimate(w.points[0], Vector2(50, 50));
  EXPECT_NE(copy.error(edge), w.graph.error(edge));
  EXPECT_EQ(copy.vertices(edge), w.graph.vertices(edge));
}

/// An error of run-time size over vertices of fixed sizes.
struct RunTimeRows {
  int rows;
  std::vector<double> error(double x, const Vector2& p) const {
    std::vector<double> e;
    for (int k = 0; k < rows; ++k) e.push_back(x * p[0] + k * p[1]);
    return e;
  }
  void jacobians(double x, const Vector2& p, Eigen::Ref<Eigen::Matrix<double, Eigen::Dynamic, 1>> Jx,
                 Eigen::Ref<Eigen::Matrix<double, Eigen::Dynamic, 2>> Jp) const {
    for (int k = 0; k < rows; ++k) {
      Jx(k, 0) = p[0];
      Jp.row(k) << x, k;
    }
  }
};

TEST(AnalyticJacobians, AreUsedForErrorsOfRunTimeSize) {
  Graph graph;
  const auto x = graph.add_vertex(3.0);
  const auto p = graph.add_vertex(Vector2(5, 7));
  const auto edge = graph.add_edge(RunTimeRows{4}, x, p);
  EXPECT_EQ(graph.edge_pools()[edge.pool]->jacobian_source(), detail::JacobianSource::kAnalytic);
  EXPECT_EQ(graph.jacobian(edge)[0], Eigen::Vector4d::Constant(5));
  EXPECT_EQ(graph.jacobian(edge)[1].col(1), Eigen::Vector4d(0, 1, 2, 3));
  EXPECT_TRUE(check_jacobians(RunTimeRows{4}, 3.0, Vector2(5, 7)).ok);
}

}  // namespace
}  // namespace boxplus
