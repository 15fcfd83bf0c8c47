// SPDX-License-Identifier: BSD-3-Clause
// optimize() names the cause if sums, products or kernels become infinite or NaN although all estimates and
// measurements are finite.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "optimize/small_graphs.h"
#include "optimize/table_entries.h"

namespace boxplus {
namespace {

using testing::HasSubstr;

TEST(Optimize, NamesTheLargestEdgeIfOnlyTheSumOverAllEdgesOverflows) {
  Graph graph;
  const auto x = graph.add_vertex(1e308, 7), y = graph.add_vertex(0.0, 8);
  graph.add_edge([](const auto& value) { return value - 1e308 - 3; }, x);
  graph.add_edge([](const auto& value) { return value - 1e154; }, y);
  graph.add_edge([](const auto& a, const auto& b) { return 1.2e-154 * a + b; }, x, y);
  const Report report = optimize(graph);
  EXPECT_EQ(report.reason, Report::Reason::kNotFinite);
  EXPECT_THAT(report.message, HasSubstr("chi2 overflows; the largest part comes from the edge"));
  EXPECT_THAT(report.message, testing::EndsWith("between vertices 7 8"));
}

TEST(Optimize, NamesTheEdgeThatMakesTheLinearSystemOverflow) {
  for (const AlgorithmKind algorithm : every_algorithm()) {
    Graph graph;
    const auto x = graph.add_vertex(1.0, 7), y = graph.add_vertex(2.0, 8);
    graph.add_edge([](const auto& value) { return value - 3; }, x);
    graph.add_edge([](const auto& a, const auto& b) { return 1e300 * (2 * a - b); }, x, y);
    const Report report = optimize(graph, {.algorithm = algorithm});
    EXPECT_EQ(report.reason, Report::Reason::kNotFinite);
    EXPECT_THAT(report.message, HasSubstr("the linear system overflows; the largest Jacobian"));
    EXPECT_THAT(report.message, testing::EndsWith("between vertices 7 8"));
  }
}

class NanWeight final : public RobustKernel {
 public:
  Rho operator()(double e2) const override { return {e2, std::nan(""), 0}; }
  std::string_view name() const override { return "NanWeight"; }
  double delta() const override { return 1; }
  std::unique_ptr<RobustKernel> clone() const override { return std::make_unique<NanWeight>(); }
};

TEST(Optimize, NamesAnEdgeWhoseKernelReturnsNan) {
  Graph graph;
  const auto x = graph.add_vertex(1.0);
  const auto edge = graph.add_edge([](const auto& value) { return value - 3; }, x);
  graph.set_kernel(edge, NanWeight());
  const Report report = optimize(graph);
  EXPECT_EQ(report.reason, Report::Reason::kNotFinite);
  EXPECT_THAT(report.message, HasSubstr("the weight of the robust kernel"));
  EXPECT_THAT(report.message, HasSubstr("between vertices 0"));
}

TEST(Optimize, DoesNotReportFalseConvergenceIfWeightsSpanMoreDigitsThanADoubleHas) {
  for (const auto algorithm : {AlgorithmKind::kDogleg, AlgorithmKind::kLevenbergMarquardt}) {
    for (const int digits : {6, 10, 14, 16, 18, 20, 60, 100, 300}) {
      Graph graph;
      const auto a = graph.add_vertex(SE2(1, 0, 0)), b = graph.add_vertex(SE2(2, 3, 0));
      graph.add_edge(Prior(SE2(0, 0, 0)), a);
      graph.add_edge(Prior(SE2(1, 0, 0)), b);
      graph.add_edge(Between(SE2(0, 0, 0)), std::pow(10.0, digits), a, b);
      const Report report = optimize(graph, {.algorithm = algorithm});
      if (digits <= 14) {
        EXPECT_TRUE(report.converged()) << digits << report;
        EXPECT_NEAR(report.chi2_final, 0.5, 1e-4);
      } else if (report.converged()) {
        EXPECT_NEAR(report.chi2_final, 0.5, 1e-4) << digits << report;
      } else {
        EXPECT_THAT(report.reason, ::testing::AnyOf(Report::Reason::kWeightSpan, Report::Reason::kNotFinite))
            << digits;
        EXPECT_THAT(report.message, HasSubstr("the edge Between<SE2> between vertices 0 1")) << digits;
      }
    }
  }
}

}  // namespace
}  // namespace boxplus
