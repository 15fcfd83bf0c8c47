// SPDX-License-Identifier: BSD-3-Clause
// The text of a Report.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "optimize/small_graphs.h"

namespace boxplus {
namespace {

using testing::HasSubstr;

TEST(Report, ShowsNanWithoutASign) {
  Report report;
  const double minus_nan = -std::numeric_limits<double>::quiet_NaN();
  report.chi2_initial = report.chi2_final = report.start.chi2_current = report.start.chi2_guess = minus_nan;
  report.records.push_back({.chi2 = minus_nan, .chi2_decrease = minus_nan});
  const std::string text = to_string(report);
  EXPECT_THAT(text, HasSubstr("chi2 nan → nan"));
  EXPECT_THAT(text, testing::Not(HasSubstr("-nan")));
}

TEST(Report, ShowsThePredictedMemoryAndTimeOfAFactorThatWasNotComputed) {
  const auto text_for = [](std::uint64_t bytes) {
    Report report;
    report.linear.refused_factor_bytes = bytes;
    report.linear.factor_seconds = 254;
    report.linear.pcg_seconds = 0.31;
    return to_string(report);
  };
  EXPECT_THAT(text_for(40), HasSubstr("take 0.0 kB and"));
  EXPECT_THAT(text_for(999'600), HasSubstr("take 1.0 MB and"));
  EXPECT_THAT(text_for(61'400'000'000),
              HasSubstr("take 61 GB and 254 s; a rough solution by pcg takes 0.31 s)"));
  EXPECT_THAT(text_for(3'140'000'000'000'000), HasSubstr("take 3140 TB and"));
}

/// A report of a run that converged.
Report converged_report(double chi2, std::int64_t degrees_of_freedom) {
  Report report;
  report.status = Report::Status::kConverged;
  report.chi2_final = chi2;
  report.rows = 100;
  report.degrees_of_freedom = degrees_of_freedom;
  return report;
}

TEST(Report, RemarksThatChi2DoesNotFitItsDegreesOfFreedom) {
  EXPECT_THAT(to_string(converged_report(4.1e6, 10)), HasSubstr("is above 4: Ω is too large"));
  EXPECT_THAT(to_string(converged_report(2.4, 10)), HasSubstr("is below 1/4: Ω is too small"));
  EXPECT_EQ(converged_report(40, 10).chi2_remark(), "");
  EXPECT_EQ(converged_report(2.5, 10).chi2_remark(), "");
}

TEST(Report, DoesNotRemarkOnChi2WithFewerThanTenDegreesOfFreedom) {
  for (const std::int64_t degrees : {-1, 0, 1, 9}) {
    EXPECT_EQ(converged_report(1e9, degrees).chi2_remark(), "");
    EXPECT_EQ(converged_report(0, degrees).chi2_remark(), "");
  }
  EXPECT_TRUE(std::isnan(converged_report(1, 0).chi2_per_degree()));
  EXPECT_TRUE(std::isnan(converged_report(1, -1).chi2_per_degree()));
}

TEST(Report, DoesNotRemarkOnChi2IfTheRunDidNotConverge) {
  Report report = converged_report(1e9, 100);
  report.status = Report::Status::kNotConverged;
  EXPECT_EQ(report.chi2_remark(), "");
}

TEST(Report, DoesNotRemarkOnALowChi2IfEdgesHaveRobustKernels) {
  Report report = converged_report(1, 100);
  report.robust_edges = 1;
  EXPECT_EQ(report.chi2_remark(), "");
  report.chi2_final = 401;
  EXPECT_NE(report.chi2_remark(), "");
}

TEST(Report, PrintsRowsAndDegreesOfFreedom) {
  const auto text_for = [](std::int64_t degrees) { return to_string(converged_report(150, degrees)); };
  EXPECT_THAT(text_for(100), HasSubstr("edges (100 rows)\n"));
  EXPECT_THAT(text_for(100), HasSubstr("fit             chi2 per degree of freedom is 1.5 (100 degrees)\n"));
  EXPECT_THAT(text_for(1), HasSubstr("is 150 (1 degree)\n"));
  EXPECT_THAT(text_for(0), HasSubstr("no degrees of freedom: as many rows as unknowns\n"));
  EXPECT_THAT(text_for(-2), HasSubstr("no degrees of freedom: 2 fewer rows than unknowns\n"));
}

TEST(DegreesOfFreedom, AreTheSameForEveryTreatmentOfTheGauge) {
  for (const GaugePolicy gauge : {GaugePolicy::kFixFirst, GaugePolicy::kDamp}) {
    Graph graph;
    add_noisy_circle(graph, 20);
    const Report report = optimize(graph, {.gauge = gauge});
    EXPECT_EQ(report.rows, 60u);
    EXPECT_EQ(report.scalars, gauge == GaugePolicy::kDamp ? 60u : 57u);
    EXPECT_EQ(report.degrees_of_freedom, 60 - 57);
    EXPECT_DOUBLE_EQ(report.chi2_per_degree(), report.chi2_final / 3);
  }
}

TEST(DegreesOfFreedom, DoNotCountFixedVerticesFixedDirectionsAndDisabledEdges) {
  Graph graph;
  const auto poses = add_noisy_circle(graph, 20);
  graph.fix(poses[0]);
  graph.fix_directions(poses[5], {1, 2});
  graph.set_enabled(graph.all_edges()[7], false);
  const Report report = optimize(graph);
  EXPECT_EQ(report.rows, 57u);
  EXPECT_EQ(report.scalars, 55u);
  EXPECT_EQ(report.degrees_of_freedom, 57 - 55);
}

/// Points that poses see. The last `once` points are seen by one pose only, in a single row.
Graph graph_with_points_seen_once(int once, GaugePolicy gauge) {
  Graph graph;
  const auto poses = add_noisy_circle(graph, 10);
  if (gauge == GaugePolicy::kError) graph.fix(poses[0]);
  const auto bearing = [](const SE2& pose, const Vector2& point) {
    const Vector2 y = pose.inverse_times(point);
    return std::atan2(y[1], y[0]);
  };
  for (int k = 0; k < 5 + once; ++k) {
    const Vector2 place(3 * std::sin(2 * k), 4 * std::cos(3 * k));
    const auto point = graph.add_vertex(place);
    graph.set_eliminated(point, true);
    for (std::size_t i = 0; i < (k < 5 ? poses.size() : 1); ++i)
      graph.add_edge(BearingObservation2(bearing(graph.estimate(poses[i]), place)), poses[i], point);
  }
  return graph;
}

TEST(DegreesOfFreedom, DoNotCountUnknownsOfAVertexBeyondTheRowsOfItsEdges) {
  for (const GaugePolicy gauge : {GaugePolicy::kFixFirst, GaugePolicy::kDamp, GaugePolicy::kError}) {
    for (const int once : {0, 1, 30}) {
      Graph graph = graph_with_points_seen_once(once, gauge);
      const Report report = optimize(graph, {.gauge = gauge});
      EXPECT_EQ(report.rows, static_cast<std::uint64_t>(30 + 50 + once));
      EXPECT_EQ(report.degrees_of_freedom, 30 + 50 - 27 - 10) << once << "\n" << report;
    }
  }
}

TEST(DegreesOfFreedom, CountAFreeScaleAsUndetermined) {
  Graph graph;
  std::vector<VertexHandle<Vector2>> points;
  for (int k = 0; k < 4; ++k) points.push_back(graph.add_vertex(Vector2(k * k, k)));
  const auto direction = [](const auto& a, const auto& b) {
    using std::atan2;
    return atan2(b[1] - a[1], b[0] - a[0]);
  };
  for (std::size_t k = 0; k < points.size(); ++k) {
    for (std::size_t j = 0; j < k; ++j) {
      const double measured = direction(graph.estimate(points[j]), graph.estimate(points[k]));
      graph.add_edge([=](const auto& a, const auto& b) { return direction(a, b) - measured; }, points[j],
                     points[k]);
    }
  }
  const Report report = optimize(graph);
  ASSERT_EQ(report.gauge.held.size(), 1u) << report;
  ASSERT_EQ(report.gauge.free.size(), 1u) << report;
  EXPECT_EQ(report.rows, 6u);
  EXPECT_EQ(report.scalars, 6u);
  EXPECT_EQ(report.degrees_of_freedom, 6 - 5);  // four points, up to position and scale
}

TEST(Report, HasALineForTheStartAndALineForEachIteration) {
  Report report;
  report.chi2_initial = report.start.chi2_current = 9;
  report.start.chi2_guess = 7;
  report.start.used = Start::kChordal;
  report.start.other_iterations = 3;
  report.records = {{.iteration = 1, .chi2 = 6}, {.iteration = 2, .chi2 = 5}};
  report.iterations = 2;
  report.chi2_final = 5;
  const std::string text = to_string(report);
  EXPECT_THAT(text, HasSubstr("chi2 9 → 5 in 2 iterations"));
  EXPECT_THAT(text, HasSubstr("; 3 iterations from the start that was not used\n"));
  const std::string table = text.substr(text.find("  iter "));
  EXPECT_THAT(table, HasSubstr("\n     0              7\n     1              6  "));
  EXPECT_THAT(table, HasSubstr("\n     2              5  "));
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 4);
}

TEST(Report, IsPrintedAsATable) {
  Graph graph;
  add_noisy_circle(graph, 20);
  const std::string text = to_string(optimize(graph));
  EXPECT_THAT(text, HasSubstr("converged: chi2"));
  EXPECT_THAT(text, HasSubstr("because"));
  EXPECT_THAT(text, HasSubstr("gauge           held vertex 0: nothing else fixes its component"));
  EXPECT_THAT(text, HasSubstr("dogleg, block_cholesky"));
}

}  // namespace
}  // namespace boxplus
