// SPDX-License-Identifier: BSD-3-Clause
#include "linearize/linearizer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "boxplus/manifold/rn.h"
#include "boxplus/manifold/se2.h"
#include "boxplus/robust/huber.h"
#include "boxplus/robust/redescending.h"
#include "linearize/bundle.h"
#include "linearize/dense_reference.h"

namespace boxplus {
namespace {

using Point = Eigen::Vector2d;
using Points = std::vector<VertexHandle<Point>>;

constexpr auto kBetween = [](const auto& a, const auto& b) { return a.inverse_times(b).vector(); };
constexpr auto kSighting = [](const auto& pose, const auto& point) { return pose.inverse_times(point); };
constexpr auto kBehind = [](const auto& point, const auto& pose) {
  return (point - pose.translation()).eval();
};
constexpr auto kPrior = [](const auto& pose) { return pose.vector(); };
constexpr auto kBearing = [](const auto& pose) { return pose.x() * pose.y() + pose.theta(); };
constexpr auto kRange = [](const SE2& a, const Point& p) { return (a.translation() - p).norm(); };

Eigen::Matrix3d full_information() {
  return (Eigen::Matrix3d() << 3, 1, 0.5, 1, 4, -1, 0.5, -1, 5).finished();
}

struct Mixed {
  Graph graph;
  std::vector<VertexHandle<SE2>> poses;
  Points points;
  std::vector<EdgeRef> edges;
};

/// Poses, points, and edges of several types. The edges differ in the order and number of their vertices and
/// in their information matrices. No vertex is fixed.
Mixed mixed_graph() {
  Mixed m;
  Graph& graph = m.graph;
  for (int k = 0; k < 4; ++k) {
    m.points.push_back(graph.add_vertex(Point(k, 2 - 0.3 * k)));
    m.poses.push_back(graph.add_vertex(SE2(k, 0.2 * k * k, 0.4 * k)));
  }
  m.edges.push_back(graph.add_edge(kPrior, m.poses[0]));
  for (std::size_t k = 0; k < 3; ++k) {
    m.edges.push_back(graph.add_edge(kBetween, full_information(), m.poses[k], m.poses[k + 1]));
    m.edges.push_back(graph.add_edge(kSighting, 2.0, m.poses[k], m.points[k + 1]));
    m.edges.push_back(
        graph.add_edge(kBehind, Eigen::Matrix2d(Point(1, 3).asDiagonal()), m.points[k], m.poses[3]));
  }
  m.edges.push_back(graph.add_edge(kRange, 0.5, m.poses[1], m.points[3]));
  const auto spread = [](const auto& pose, const auto& points) {
    auto sum = pose.translation();
    for (const auto& p : points) sum -= p;
    return sum;
  };
  m.edges.push_back(graph.add_edge(spread, m.poses[2], Points{m.points[0], m.points[3], m.points[1]}));
  m.edges.push_back(graph.add_edge(spread, m.poses[0], Points{m.points[2]}));
  const auto size = graph.add_vertex(Eigen::VectorXd::LinSpaced(5, 1, 5).eval());
  const auto stack = [](const auto& x, const auto& p) { return (x * p[0]).eval(); };
  m.edges.push_back(graph.add_edge(stack, size, m.points[1]));
  return m;
}

TEST(Linearizer, EqualsTheDenseReferenceForMixedTypes) {
  const Mixed m = mixed_graph();
  const Plan plan = make_plan(m.graph, {});
  EXPECT_EQ(plan.scalars(), 4 * 3 + 4 * 2 + 5u);
  expect_equals_reference(m.graph, plan);
}

TEST(Linearizer, LeavesOutFixedVertices) {
  Mixed m = mixed_graph();
  m.graph.fix(m.poses[1]);
  m.graph.fix(m.points[3]);
  const Plan plan = make_plan(m.graph, {});
  EXPECT_EQ(plan.scalars(), 3 * 3 + 3 * 2 + 5u);
  expect_equals_reference(m.graph, plan);
}

TEST(Linearizer, PutsEliminatedVerticesFirst) {
  Mixed m = mixed_graph();
  m.graph.set_eliminated(m.poses[1], true);
  m.graph.set_eliminated(m.poses[3], true);
  const Plan plan = make_plan(m.graph, {});
  EXPECT_EQ(plan.eliminated_blocks, 2u);
  EXPECT_EQ(plan.block_vertex[0], VertexRef(m.poses[1]));
  EXPECT_EQ(plan.block_vertex[1], VertexRef(m.poses[3]));
  expect_equals_reference(m.graph, plan);
}

TEST(Linearizer, IgnoresDisabledEdgesWithoutANewPlan) {
  Mixed m = mixed_graph();
  const Plan plan = make_plan(m.graph, {});
  Linearizer linearizer(m.graph, plan);
  const double all = linearizer.chi2();
  const double edge = m.graph.chi2(m.edges[2]);
  m.graph.set_enabled(m.edges[2], false);
  EXPECT_NEAR(linearizer.chi2(), all - edge, 1e-12 * all);
  expect_equals_reference(m.graph, plan);
}

TEST(Linearizer, WeightsEdgesByTheirKernels) {
  Mixed m = mixed_graph();
  for (std::size_t k = 0; k < m.edges.size(); k += 2) m.graph.set_kernel(m.edges[k], Huber(0.3));
  m.graph.set_kernel(m.edges[1], Cauchy(0.5));
  const Plan plan = make_plan(m.graph, {});
  expect_equals_reference(m.graph, plan);
  expect_equals_reference(m.graph, plan, {.triggs_correction = true});
  Linearizer linearizer(m.graph, plan);
  EXPECT_NEAR(linearizer.chi2(), m.graph.chi2(), 1e-12 * m.graph.chi2());
}

/// H and the gradient of a graph with one scalar vertex x and one edge. The error of the edge is x, and K is
/// its kernel.
template <class K>
std::pair<double, double> one_edge(double x, const K& kernel, bool triggs) {
  Graph graph;
  const auto a = graph.add_vertex(x);
  graph.set_kernel(graph.add_edge([](const auto& v) { return 1.0 * v; }, a), kernel);
  const Plan plan = make_plan(graph, {});
  Linearizer linearizer(graph, plan);
  linearizer.linearize({.triggs_correction = triggs});
  return {linearizer.values()[0], linearizer.gradient()[0]};
}

/// A custom kernel, ρ = e² exp(−e²), which decreases for e² > 1.
class Falling final : public RobustKernel {
 public:
  Rho operator()(double e2) const override {
    const double f = std::exp(-e2);
    return {e2 * f, (1 - e2) * f, (e2 - 2) * f};
  }
  std::string_view name() const override { return "Falling"; }
  double delta() const override { return 1; }
  std::unique_ptr<RobustKernel> clone() const override { return std::make_unique<Falling>(*this); }
};

TEST(Linearizer, ClampsANegativeWeightToZero) {
  EXPECT_LT(Falling()(4).first, 0);
  EXPECT_EQ(one_edge(2, Falling(), false), (std::pair{0.0, 0.0}));
  EXPECT_EQ(one_edge(2, Falling(), true).second, 0);
}

TEST(Linearizer, ComputesTheExactHessianOfAKernelWithTriggsCorrectionIfThisHessianIsPositive) {
  // With the Cauchy kernel, half of the second derivative of ρ(x²) is ρ′ + 2x²ρ″ = (1 − x²)/(1 + x²)².
  const auto [hessian, gradient] = one_edge(0.5, Cauchy(1), true);
  EXPECT_NEAR(hessian, 0.75 / (1.25 * 1.25), 1e-15);
  EXPECT_NEAR(gradient, 0.5 / 1.25, 1e-15);
  EXPECT_NEAR(one_edge(0.5, Cauchy(1), false).first, 1 / 1.25, 1e-15);
}

/// A custom kernel that does not know its second derivative.
class WithoutSecondDerivative final : public RobustKernel {
 public:
  Rho operator()(double e2) const override {
    const Rho rho = Huber(1)(e2);
    return {rho.value, rho.first, std::numeric_limits<double>::quiet_NaN()};
  }
  std::string_view name() const override { return "WithoutSecondDerivative"; }
  double delta() const override { return 1; }
  std::unique_ptr<RobustKernel> clone() const override {
    return std::make_unique<WithoutSecondDerivative>(*this);
  }
};

TEST(Linearizer, MakesNoTriggsCorrectionWhereTheSecondDerivativeOfAKernelIsNotFinite) {
  EXPECT_EQ(one_edge(3, WithoutSecondDerivative(), true), one_edge(3, Huber(1), false));
}

TEST(Linearizer, MakesNoTriggsCorrectionWhereAKernelIsConcave) {
  EXPECT_EQ(one_edge(3, Cauchy(1), true), one_edge(3, Cauchy(1), false));
}

TEST(Linearizer, KeepsALittleCurvatureWithTriggsCorrectionWhereAKernelIsAStraightLine) {
  const auto [hessian, gradient] = one_edge(3, Huber(1), true);
  EXPECT_NEAR(hessian, 1e-4 * one_edge(3, Huber(1), false).first, 1e-15);
  EXPECT_NEAR(gradient, 1, 1e-13);
}

TEST(Linearizer, ComputesAPositiveSemiDefiniteHessianWithTriggsCorrection) {
  Mixed m = mixed_graph();
  for (const EdgeRef& edge : m.edges) m.graph.set_kernel(edge, Huber(0.2));
  const Plan plan = make_plan(m.graph, {});
  Linearizer linearizer(m.graph, plan);
  linearizer.linearize({.triggs_correction = true});
  const Eigen::MatrixXd hessian = dense_matrix(plan.structure, linearizer.values());
  const Eigen::VectorXd eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(hessian).eigenvalues();
  EXPECT_GE(eigenvalues[0], -1e-13 * eigenvalues[eigenvalues.size() - 1]);
}

TEST(Linearizer, BuildsTheSameSystemFromNumericJacobians) {
  const Mixed m = mixed_graph();
  const Plan plan = make_plan(m.graph, {});
  Linearizer exact(m.graph, plan), numeric(m.graph, plan);
  exact.linearize({});
  numeric.linearize({.numeric_jacobians = true});
  for (std::size_t k = 0; k < exact.values().size(); ++k)
    EXPECT_NEAR(exact.values()[k], numeric.values()[k], 1e-7);
}

TEST(Linearizer, AcceptsAnErrorWithoutRows) {
  Graph graph;
  const auto a = graph.add_vertex(Eigen::Matrix<double, 6, 1>::Zero().eval());
  const auto b = graph.add_vertex(1.0);
  graph.add_edge(
      [](const auto& x, const auto&) { return std::vector<std::remove_cvref_t<decltype(x[0])>>(); }, a, b);
  const Plan plan = make_plan(graph, {});
  Linearizer linearizer(graph, plan);
  linearizer.linearize({});
  EXPECT_EQ(linearizer.chi2(), 0);
  EXPECT_THAT(std::vector(linearizer.gradient().begin(), linearizer.gradient().end()), testing::Each(0));
}

/// A long chain of poses with loop closures, points and kernels.
Graph large_graph() {
  Graph graph;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<VertexHandle<SE2>> poses;
  std::vector<VertexHandle<Point>> points;
  for (int k = 0; k < 1200; ++k) poses.push_back(graph.add_vertex(SE2(k, uniform(random), uniform(random))));
  for (int k = 0; k < 400; ++k) points.push_back(graph.add_vertex(Point(3 * k, uniform(random))));
  for (std::size_t k = 0; k + 1 < poses.size(); ++k)
    graph.add_edge(kBetween, full_information(), poses[k], poses[k + 1]);
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const auto edge = graph.add_edge(kSighting, 2.0, poses[k], points[(k * 7) % points.size()]);
    if (k % 3 == 0) graph.set_kernel(edge, Huber(1));
    graph.add_edge(kBehind, points[(k * 11) % points.size()], poses[k]);
    if (k % 2 == 0) graph.add_edge(kBetween, poses[(k * 17 + 1) % poses.size()], poses[k]);
    // Several successive unary edges at one vertex. Another worker may own the vertices before and after it.
    for (std::size_t n = 0; n < k % 4; ++n) {
      const auto unary =
          graph.add_edge(kBearing, 1.0 + 0.1 * static_cast<double>(n), poses[(k * 13) % poses.size()]);
      if (k % 5 == 0) graph.set_kernel(unary, Huber(1));
    }
  }
  return graph;
}

bool same_bits(std::span<const double> a, std::span<const double> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

TEST(Linearizer, ComputesTheSameBitsForAnyNumberOfWorkers) {
  for (const bool eliminate : {false, true}) {
    const Graph graph = eliminate ? make_bundle(12, 600, true).graph : large_graph();
    const Plan one = make_plan(graph, {.threads = 1});
    ASSERT_GT(one.edge_count, 3000u);
    Linearizer reference(graph, one);
    reference.linearize({});
    const double chi2 = reference.chi2();
    for (const int threads : {2, 3, 5}) {
      const Plan plan = make_plan(graph, {.threads = threads});
      EXPECT_EQ(plan.chunks.size(), eliminate ? one.chunks.size() : static_cast<std::size_t>(threads));
      EXPECT_EQ(plan.workers, std::min(threads, static_cast<int>(plan.chunks.size())));
      Linearizer linearizer(graph, plan);
      linearizer.linearize({});
      EXPECT_TRUE(same_bits(linearizer.values(), reference.values()));
      EXPECT_TRUE(same_bits(linearizer.gradient(), reference.gradient()));
      EXPECT_EQ(linearizer.chi2(), chi2);
    }
  }
}

TEST(Linearizer, ReportsEachBatchOfEliminatedColumnsWhenItsValuesAreFinal) {
  const Graph graph = make_bundle(12, 600, true).graph;
  const Plan plan = make_plan(graph, {.threads = 3});
  ASSERT_GT(plan.chunks.size(), 2u);
  EXPECT_EQ(make_plan(graph, {.threads = 1}).chunks.size(), plan.chunks.size());
  Linearizer linearizer(graph, plan);
  linearizer.linearize({});
  const std::vector<double> values(linearizer.values().begin(), linearizer.values().end());
  const std::vector<double> gradient(linearizer.gradient().begin(), linearizer.gradient().end());
  for (const int groups : {1, 2, static_cast<int>(plan.chunks.size())}) {
    std::vector<std::uint32_t> ends(static_cast<std::size_t>(groups), BlockStructure::kAbsent);
    std::vector<std::uint32_t> starts(ends);
    std::vector<int> differences(ends.size(), 0);
    linearizer.linearize({}, groups, [&](const Linearizer::Batch& batch) {
      const auto g = static_cast<std::size_t>(batch.slice);
      const auto [first, last] = std::pair(batch.first, batch.last);
      if (starts[g] == BlockStructure::kAbsent) starts[g] = ends[g] = first;
      differences[g] += first != ends[g];
      ends[g] = last;
      const std::uint32_t begin = plan.first_value(first), end = plan.first_value(last);
      differences[g] += batch.values != linearizer.values().data() + begin;
      for (std::uint32_t i = begin; i < end; ++i) differences[g] += linearizer.values()[i] != values[i];
      for (std::uint32_t i = plan.structure.offset[first]; i < plan.structure.offset[last]; ++i)
        differences[g] += linearizer.gradient()[i] != gradient[i];
    });
    EXPECT_THAT(differences, testing::Each(0));
    EXPECT_EQ(starts[0], 0u);
    for (std::size_t g = 1; g < starts.size(); ++g) EXPECT_EQ(starts[g], ends[g - 1]);
    EXPECT_EQ(ends.back(), plan.eliminated_blocks);
    EXPECT_TRUE(same_bits(linearizer.values(), values));
  }
}

TEST(Linearizer, EqualsTheDenseReferenceForManyUnaryEdgesOfOneVertex) {
  Mixed m = mixed_graph();
  for (std::size_t k = 0; k < 200; ++k) {
    const auto& pose = m.poses[k / 50];
    const double weight = 0.5 + 0.01 * static_cast<double>(k);
    const EdgeRef row = m.graph.add_edge(kBearing, weight, pose);
    const EdgeRef rows = k % 3 == 0 ? m.graph.add_edge(kPrior, full_information(), pose)
                                    : m.graph.add_edge(kPrior, weight, m.poses[k % 4]);
    if (k % 7 == 0) m.graph.set_kernel(row, Huber(0.3));
    if (k % 5 == 0) m.graph.set_kernel(rows, Huber(0.3));
    if (k % 11 == 0) m.graph.set_enabled(row, false);
  }
  expect_equals_reference(m.graph, make_plan(m.graph, {}));
  m.graph.fix(m.poses[1]);
  expect_equals_reference(m.graph, make_plan(m.graph, {}));
}

TEST(Linearizer, SumsChi2Pairwise) {
  // A sum of 4096 terms of 0.1, one after the other, loses digits. A pairwise sum does not.
  Graph graph;
  const double root = std::sqrt(0.1);
  double in_order = 0;
  for (int k = 0; k < 4096; ++k) {
    graph.add_edge([](double x) { return x; }, graph.add_vertex(root));
    in_order += root * root;
  }
  const Plan plan = make_plan(graph, {});
  Linearizer linearizer(graph, plan);
  const double exact = 4096 * (root * root);
  EXPECT_NE(in_order, exact);
  EXPECT_LE(std::abs(linearizer.chi2() - exact), 10 * 5.7e-14);
  EXPECT_LT(std::abs(linearizer.chi2() - exact), std::abs(in_order - exact));
}

}  // namespace
}  // namespace boxplus
