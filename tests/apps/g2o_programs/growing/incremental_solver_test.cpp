// SPDX-License-Identifier: BSD-3-Clause
#include "growing/incremental_solver.h"

#include <gtest/gtest.h>

#include "boxplus/testing/simulate.h"
#include "growing/graph_feed.h"

namespace boxplus::programs {
namespace {

using Work = IncrementalSolver::Work;

TEST(IncrementalSolver, WorkIsDueAfterNewVertices) {
  const Simulation simulation = simulate(World::kManhattan, {.poses = 100});
  Graph graph;
  GraphFeed feed(simulation.graph, simulation.edges, graph);
  IncrementalSolver solver(graph, {.update_every = 10, .batch_every = 40});
  int updates = 0, batches = 0;
  while (feed.step()) {
    const Work work = solver.solve();
    updates += work == Work::kUpdate;
    batches += work == Work::kBatch;
    if (work != Work::kNothing) {
      EXPECT_TRUE(solver.summary().converged) << solver.summary().message;
    }
  }
  EXPECT_EQ(std::pair(updates, batches), std::pair(8, 2));
}

TEST(IncrementalSolver, TheFirstPoseKeepsItsEstimateIfNothingIsFixed) {
  Simulation simulation = simulate(World::kManhattan, {.poses = 300});
  simulation.graph.unfix(*simulation.graph.find_vertex(0));
  Graph graph;
  GraphFeed feed(simulation.graph, simulation.edges, graph);
  IncrementalSolver solver(graph, {.update_every = 5});
  while (feed.step()) solver.solve();
  solver.converge();
  EXPECT_TRUE(solver.summary().converged);
  EXPECT_FALSE(graph.is_fixed(*graph.find_vertex(0)));
  EXPECT_EQ(graph.estimate(graph.vertex<SE2>(0)).vector(),
            simulation.graph.estimate(simulation.graph.vertex<SE2>(0)).vector());
}

TEST(IncrementalSolver, AGrownGraphEndsAtTheOptimumOfTheWholeGraph) {
  for (const World world : {World::kManhattan, World::kCity, World::kSphere, World::kPlanes}) {
    Simulation simulation = simulate(world, {.poses = 400, .seed = 7});
    const Report best = optimize(simulation.truth);
    for (const bool pcg : {false, true}) {
      Graph graph;
      GraphFeed feed(simulation.graph, simulation.edges, graph);
      IncrementalSolver solver(graph, {.pcg = pcg});
      while (feed.step()) solver.solve();
      solver.converge();
      EXPECT_TRUE(solver.summary().converged) << to_string(world);
      EXPECT_NEAR(solver.summary().chi2, best.chi2_final, 1e-5 * best.chi2_final) << to_string(world) << pcg;
    }
  }
}

}  // namespace
}  // namespace boxplus::programs
