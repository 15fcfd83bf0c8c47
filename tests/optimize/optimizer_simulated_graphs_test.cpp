// SPDX-License-Identifier: BSD-3-Clause
// Simulated graphs, whose true poses are known. At the optimum, chi2 is not above the chi2 of the truth, and
// it is as large as the noise predicts.
#include <gtest/gtest.h>

#include <cmath>

#include "boxplus/optimize/optimizer.h"
#include "boxplus/testing/simulate.h"
#include "sanitized.h"

namespace boxplus {
namespace {

class SimulatedGraphs : public ::testing::TestWithParam<World> {};

/// The total number of rows of all errors.
double measurement_rows(const Graph& graph) {
  double rows = 0;
  for (const EdgeRef& edge : graph.all_edges()) rows += graph.information(edge).rows;
  return rows;
}

TEST_P(SimulatedGraphs, EndAtTheChi2ThatTheNoisePredictsAndNotAboveTheChi2OfTheTruth) {
  for (std::uint64_t seed = 1; seed <= (kSanitized ? 3 : 20); ++seed) {
    Simulation simulation = simulate(GetParam(), {.poses = 500, .seed = seed});
    const double rows = measurement_rows(simulation.graph);
    const Report report = optimize(simulation.graph, {.start = Start::kAutomatic});
    ASSERT_TRUE(report.converged()) << "seed " << seed << "\n" << report;
    EXPECT_LE(report.chi2_final, simulation.truth.chi2()) << "seed " << seed << "\n" << report;
    // With d degrees of freedom, the chi2 of a linear problem has mean d and variance 2 d.
    const double degrees_of_freedom = rows - report.scalars;
    ASSERT_GT(degrees_of_freedom, 100);
    const double sigma = std::sqrt(2 / degrees_of_freedom);
    EXPECT_NEAR(report.chi2_final / degrees_of_freedom, 1, 5 * sigma) << "seed " << seed << "\n" << report;
  }
}

TEST_P(SimulatedGraphs, WithoutNoiseAreFittedExactlyInFewIterations) {
  for (const Start start : {Start::kAutomatic, Start::kCurrent, Start::kChordal}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      Simulation simulation = simulate(GetParam(), {.poses = 500, .seed = seed, .noise = 0});
      const Report report = optimize(simulation.graph, {.start = start});
      EXPECT_TRUE(report.converged()) << "seed " << seed << "\n" << report;
      EXPECT_LT(report.chi2_final, 1e-18 * report.scalars);
      EXPECT_LT(report.records.size(), 15u) << "seed " << seed << "\n" << report;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Worlds, SimulatedGraphs,
                         ::testing::Values(World::kManhattan, World::kSphere, World::kTorus, World::kGrid,
                                           World::kCity),
                         [](const auto& test) { return std::string(to_string(test.param)); });

}  // namespace
}  // namespace boxplus
