// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/testing/false_closures.h"

#include <gmock/gmock.h>

#include "boxplus/base/error.h"
#include "boxplus/testing/simulate.h"
#include "boxplus/types/slam2d.h"

namespace boxplus {
namespace {

TEST(AddFalseClosures, AddsTheFractionOfClosuresThatContradictTheEstimates) {
  for (const World world : {World::kManhattan, World::kSphere}) {
    Graph graph = simulate(world, {.poses = 400}).truth;
    const std::size_t before = graph.edge_count(), closures = before - (graph.vertex_count() - 1);
    const std::vector<EdgeRef> added = add_false_closures(graph, {.fraction = 0.5, .group = 5});
    EXPECT_EQ(added.size(), closures);
    EXPECT_EQ(graph.edge_count(), before + closures);
    for (const EdgeRef& edge : added) EXPECT_GT(graph.chi2(edge), 100);
  }
}

TEST(AddFalseClosures, AddsTheSameClosuresForTheSameSeed) {
  const auto chi2_with = [](std::uint64_t seed) {
    Graph graph = simulate(World::kManhattan, {.poses = 200}).truth;
    add_false_closures(graph, {.seed = seed});
    return graph.chi2();
  };
  EXPECT_EQ(chi2_with(1), chi2_with(1));
  EXPECT_NE(chi2_with(1), chi2_with(2));
}

TEST(AddFalseClosures, ThrowsForOptionsOutOfTheirRangesAndWithoutClosures) {
  Graph graph = simulate(World::kManhattan, {.poses = 200}).truth;
  EXPECT_THROW(add_false_closures(graph, {.fraction = 1}), InvalidArgument);
  EXPECT_THROW(add_false_closures(graph, {.group = 0}), InvalidArgument);
  Graph empty;
  EXPECT_THROW(add_false_closures(empty), InvalidArgument);
}

}  // namespace
}  // namespace boxplus
