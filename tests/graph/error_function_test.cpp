// SPDX-License-Identifier: BSD-3-Clause
// The forms that an error function may take.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "boxplus/graph/graph.h"
#include "boxplus/graph/numeric.h"
#include "boxplus/manifold/rn.h"

namespace boxplus {
namespace {

using Point = Eigen::Vector2d;
using Handles = std::vector<VertexHandle<double>>;
using testing::ElementsAre;

template <class E>
detail::JacobianSource source(const Graph& graph, EdgeHandle<E> edge) {
  return graph.edge_pools()[edge.pool]->jacobian_source();
}

TEST(Edge, AGenericLambdaGetsExactJacobians) {
  Graph graph;
  const auto a = graph.add_vertex(Point(1, 2)), b = graph.add_vertex(Point(4, 6));
  const auto edge = graph.add_edge([](const auto& p, const auto& q) { return (q - p).eval(); }, a, b);
  EXPECT_THAT(graph.error(edge), ElementsAre(3, 4));
  EXPECT_EQ(graph.chi2(edge), 25);
  EXPECT_EQ(source(graph, edge), detail::JacobianSource::kAutomatic);
}

TEST(Edge, ALambdaMayCaptureItsMeasurement) {
  Graph graph;
  const auto a = graph.add_vertex(4.0);
  const auto make = [](double target) { return [target](const auto& x) { return x - target; }; };
  const auto edge = graph.add_edge(make(1), a);
  EXPECT_EQ(graph.chi2(edge), 9);
  graph.set_measurement(edge, make(2));
  EXPECT_EQ(graph.chi2(edge), 4);
  graph.remove(edge);
  const auto next = graph.add_edge(make(3), a);
  EXPECT_EQ(next.slot, edge.slot);
  EXPECT_EQ(graph.chi2(next), 1);
}

TEST(Edge, AFunctionOfDoublesIsDifferentiatedNumerically) {
  Graph graph;
  const auto a = graph.add_vertex(3.0);
  const auto edge = graph.add_edge([](double x) { return x * x; }, a);
  EXPECT_EQ(source(graph, edge), detail::JacobianSource::kNumeric);
  EXPECT_EQ(graph.chi2(edge), 81);
}

TEST(Edge, AGenericFunctionInsideNumericIsDifferentiatedNumerically) {
  Graph graph;
  const auto a = graph.add_vertex(3.0);
  // Only the signature is generic: the body works with a double only.
  const auto body = [](const auto& x) { return static_cast<double>(static_cast<long>(x)) + x; };
  EXPECT_EQ(source(graph, graph.add_edge(Numeric{body}, a)), detail::JacobianSource::kNumeric);
}

struct Analytic {
  double factor = 2;
  template <class S>
  S error(const S& x, const Eigen::Matrix<S, 2, 1>& p) const {
    return factor * x * p[0] + p[1];
  }
  void jacobians(double x, const Point& p, Eigen::Ref<Eigen::Matrix<double, 1, 1>> Jx,
                 Eigen::Ref<Eigen::Matrix<double, 1, 2>> Jp) const {
    Jx(0, 0) = factor * p[0];
    Jp << factor * x, 1;
  }
};

TEST(Edge, AnalyticJacobiansOfTheErrorFunctionAreUsed) {
  Graph graph;
  const auto edge = graph.add_edge(Analytic{}, graph.add_vertex(3.0), graph.add_vertex(Point(5, 7)));
  EXPECT_EQ(source(graph, edge), detail::JacobianSource::kAnalytic);
  const detail::EdgePool& pool = *graph.edge_pools()[edge.pool];
  for (const bool numeric : {false, true}) {
    std::array<double, 1> error{};
    std::array<double, 3> jacobian{};
    detail::EdgeTile tile{.error = error.data(), .jacobian = jacobian.data()};
    pool.linearize(std::span(&edge.slot, 1), tile, numeric);
    EXPECT_EQ(error[0], 37);
    EXPECT_THAT(jacobian, testing::Pointwise(testing::DoubleNear(1e-9), {10.0, 6.0, 1.0}));
  }
}

/// An error function over Eigen::Matrix. The compiler cannot deduce S from a boxplus Vector<S, 2>.
struct Eigens {
  template <class S>
  Eigen::Matrix<S, 2, 1> error(const Eigen::Matrix<S, 2, 1>& p, const S& scale) const {
    return scale * p;
  }
};

TEST(Edge, ATemplateOverEigenVectorsIsDifferentiatedExactly) {
  Graph graph;
  const auto scale = graph.add_vertex(2.0);
  for (const auto& point : {graph.add_vertex(Vector2(3, 4)), graph.add_vertex(Eigen::Vector2d(3, 4))}) {
    const auto edge = graph.add_edge(Eigens{}, point, scale);
    EXPECT_THAT(graph.error(edge), ElementsAre(6, 8));
    EXPECT_EQ(source(graph, edge), detail::JacobianSource::kAutomatic);
    std::array<double, 2> error{};
    std::array<double, 6> jacobian{};
    detail::EdgeTile tile{.error = error.data(), .jacobian = jacobian.data()};
    graph.edge_pools()[edge.pool]->linearize(std::span(&edge.slot, 1), tile, false);
    EXPECT_THAT(jacobian, ElementsAre(2, 0, 0, 2, 3, 4));
  }
}

/// An error function over a range of Eigen::Matrix. Here, too, the compiler cannot deduce S.
struct EigensSum {
  template <class S>
  Eigen::Matrix<S, 2, 1> error(const S& scale, std::span<const Eigen::Matrix<S, 2, 1>> points) const {
    Eigen::Matrix<S, 2, 1> sum = Eigen::Matrix<S, 2, 1>::Zero();
    for (const auto& p : points) sum += scale * p;
    return sum;
  }
};

TEST(Edge, ARangeMayBeASpanOfEigenVectors) {
  Graph graph;
  const auto scale = graph.add_vertex(2.0);
  const std::vector<VertexHandle<Eigen::Vector2d>> points{graph.add_vertex(Eigen::Vector2d(3, 4)),
                                                          graph.add_vertex(Vector2(5, 6))};
  const auto exact = graph.add_edge(EigensSum{}, scale, points);
  EXPECT_THAT(graph.error(exact), ElementsAre(16, 20));
  EXPECT_EQ(source(graph, exact), detail::JacobianSource::kAutomatic);
  EXPECT_EQ(graph.jacobian(exact)[0], Vector2(8, 10));
  EXPECT_EQ(graph.jacobian(exact)[2], 2 * Eigen::Matrix2d::Identity());
  const auto plain =
      graph.add_edge([](std::span<const Eigen::Vector2d> p) { return p[1][0] - p[0][0]; }, points);
  EXPECT_THAT(graph.error(plain), ElementsAre(2));
}

TEST(Edge, AnErrorMayBeAScalarAnArrayOrAVector) {
  Graph graph;
  const auto a = graph.add_vertex(3.0);
  EXPECT_THAT(graph.error(graph.add_edge([](double x) { return x; }, a)), ElementsAre(3));
  EXPECT_THAT(graph.error(graph.add_edge(
                  [](double x) {
                    return std::array{x, 2 * x};
                  },
                  a)),
              ElementsAre(3, 6));
  EXPECT_THAT(graph.error(graph.add_edge(
                  [](double x) {
                    return std::vector{x, x, x};
                  },
                  a)),
              ElementsAre(3, 3, 3));
  EXPECT_THAT(graph.error(graph.add_edge([](double x) { return Eigen::VectorXd::Constant(2, x).eval(); }, a)),
              ElementsAre(3, 3));
}

TEST(Edge, VerticesMayHaveThreeDifferentTypes) {
  Graph graph;
  const auto a = graph.add_vertex(3.0);
  const auto b = graph.add_vertex(Point(1, 2));
  const auto c = graph.add_vertex(Eigen::Vector3d(1, 2, 3));
  const auto edge =
      graph.add_edge([](const auto& x, const auto& y, const auto& z) { return x + y[1] + z[2]; }, a, b, c);
  EXPECT_THAT(graph.error(edge), ElementsAre(8));
  EXPECT_EQ(graph.edge_pools()[edge.pool]->shape(edge.slot).cols, 6);
}

constexpr auto kSum = [](const auto& first, const auto& tail) {
  auto sum = first;
  for (const auto& x : tail) sum += x;
  return sum;
};

TEST(Edge, TheNumberOfVerticesMayBeChosenAtRunTime) {
  Graph graph;
  const auto a = graph.add_vertex(1.0), b = graph.add_vertex(2.0), c = graph.add_vertex(4.0);
  const auto two = graph.add_edge(kSum, a, Handles{b});
  const auto three = graph.add_edge(kSum, a, Handles{b, c});
  const auto one = graph.add_edge(kSum, a, Handles{});
  EXPECT_EQ(two.pool, three.pool);
  EXPECT_THAT(graph.error(one), ElementsAre(1));
  EXPECT_THAT(graph.error(two), ElementsAre(3));
  EXPECT_THAT(graph.error(three), ElementsAre(7));
  EXPECT_THAT(graph.vertices(three), ElementsAre(VertexRef(a), VertexRef(b), VertexRef(c)));
  EXPECT_THROW(graph.add_edge(kSum, a, Handles{b, a}), InvalidArgument);
  EXPECT_THROW(graph.add_edge([](const auto& tail) { return tail[0]; }, Handles{}), InvalidArgument);
  graph.remove(c);
  EXPECT_FALSE(graph.contains(three));
  EXPECT_TRUE(graph.contains(two));
}

TEST(Edge, ASlotIsReusedForAnEdgeWithTheSameNumberOfVertices) {
  Graph graph;
  const auto a = graph.add_vertex(1.0), b = graph.add_vertex(2.0), c = graph.add_vertex(4.0);
  const auto two = graph.add_edge(kSum, a, Handles{b});
  const auto three = graph.add_edge(kSum, a, Handles{b, c});
  graph.remove(two);
  graph.remove(three);
  const auto again = graph.add_edge(kSum, c, Handles{b});
  EXPECT_EQ(again.slot, two.slot);
  EXPECT_THAT(graph.error(again), ElementsAre(6));
  EXPECT_EQ(graph.add_edge(kSum, c, Handles{b, a}).slot, three.slot);
}

TEST(Edge, VerticesMayHaveRunTimeSize) {
  Graph graph;
  const auto a = graph.add_vertex(Eigen::VectorXd::Constant(3, 2.0).eval());
  const auto b = graph.add_vertex(Vector<double, kDynamic>::Constant(3, 5.0).eval());
  EXPECT_EQ(graph.tangent_dim(a), 3);
  const auto edge = graph.add_edge([](const auto& x, const auto& y) { return (y - x).eval(); }, a, b);
  EXPECT_THAT(graph.error(edge), ElementsAre(3, 3, 3));
  const detail::EdgeShape shape = graph.edge_pools()[edge.pool]->shape(edge.slot);
  EXPECT_EQ(shape.rows, 3);
  EXPECT_EQ(shape.cols, 6);
}

TEST(Edge, AnErrorWhoseNumberOfRowsChangesIsRefused) {
  Graph graph;
  const auto a = graph.add_vertex(2.0);
  const auto edge =
      graph.add_edge([](double x) { return std::vector<double>(static_cast<std::size_t>(x), 1.0); }, a);
  EXPECT_EQ(graph.chi2(edge), 2);
  graph.set_estimate(a, 3.0);
  EXPECT_THROW((void)graph.chi2(edge), InvalidArgument);
}

TEST(Edge, ItsMeasurementCanBeReadAndReplaced) {
  Graph graph;
  const auto edge = graph.add_edge(Analytic{3}, graph.add_vertex(1.0), graph.add_vertex(Point(1, 0)));
  EXPECT_EQ(graph.measurement(edge).factor, 3);
  graph.set_measurement(edge, Analytic{5});
  EXPECT_EQ(graph.measurement(edge).factor, 5);
  EXPECT_EQ(graph.chi2(edge), 25);
}

}  // namespace
}  // namespace boxplus
