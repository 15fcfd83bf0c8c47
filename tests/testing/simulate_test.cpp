// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/testing/simulate.h"

#include <gmock/gmock.h>

#include "boxplus/base/error.h"
#include "boxplus/optimize/optimize.h"
#include "boxplus/types/slam2d.h"

namespace boxplus {
namespace {

constexpr World kWorlds[] = {World::kSphere, World::kTorus, World::kGrid, World::kManhattan,
                             World::kLandmarks};

TEST(Simulate, DrawsItsNoiseFromTheInformation) {
  for (World world : kWorlds) {
    const Simulation simulation = simulate(world, {.poses = 400, .seed = 3});
    double rows = 0;
    for (const EdgeRef& edge : simulation.truth_edges) rows += simulation.truth.information(edge).rows;
    // A χ² variable of so many degrees of freedom: mean n, deviation √(2n).
    EXPECT_NEAR(simulation.truth.chi2(), rows, 5 * std::sqrt(2 * rows)) << to_string(world);
  }
}

TEST(Simulate, WithoutNoiseStartsAtTheTruth) {
  for (World world : kWorlds) {
    const Simulation simulation = simulate(world, {.poses = 100, .noise = 0});
    EXPECT_LT(simulation.graph.chi2(), 1e-12) << to_string(world);
    EXPECT_LT(simulation.truth.chi2(), 1e-12) << to_string(world);
  }
}

TEST(Simulate, IsSolvedBelowTheChi2OfTheTruth) {
  for (World world : kWorlds) {
    Simulation simulation = simulate(world, {.poses = 225, .seed = 5});
    Options options;
    options.start = Start::kAutomatic;
    const Report report = optimize(simulation.graph, options);
    EXPECT_TRUE(report.converged()) << to_string(world) << ": " << report.message;
    EXPECT_LT(report.chi2_final, simulation.truth.chi2()) << to_string(world);
  }
}

TEST(Simulate, GivesTheSameGraphForTheSameSeed) {
  const SimulationOptions options{.poses = 50, .seed = 9};
  EXPECT_EQ(simulate(World::kManhattan, options).graph.chi2(),
            simulate(World::kManhattan, options).graph.chi2());
  EXPECT_NE(simulate(World::kManhattan, options).graph.chi2(),
            simulate(World::kManhattan, {.poses = 50, .seed = 10}).graph.chi2());
}

TEST(Simulate, RefusesNonsense) {
  EXPECT_THROW(simulate(World::kSphere, {.poses = 1}), InvalidArgument);
  EXPECT_THROW(simulate(World::kSphere, {.noise = -1}), InvalidArgument);
}

}  // namespace
}  // namespace boxplus
