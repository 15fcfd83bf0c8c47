// SPDX-License-Identifier: BSD-3-Clause
// The text of a Report.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
