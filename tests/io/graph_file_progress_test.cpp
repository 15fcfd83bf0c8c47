// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "base/progress_notes.h"
#include "boxplus/io/graph_file.h"
#include "boxplus/testing/simulate.h"
#include "boxplus/testing/simulate_bundle.h"

namespace boxplus {
namespace {

using testing::AllOf;
using testing::Each;
using testing::Ge;
using testing::Le;
using testing::SizeIs;

void expect_shares_that_grow(const Notes& notes, std::size_t least) {
  EXPECT_THAT(notes.shares, SizeIs(Ge(least)));
  EXPECT_TRUE(std::is_sorted(notes.shares.begin(), notes.shares.end()));
  EXPECT_THAT(notes.shares, Each(AllOf(Ge(0), Le(1))));
}

TEST(Progress, GrowsWhileFilesAreReadAndWrittenAndGraphsSimulated) {
  Simulation simulation;
  expect_shares_that_grow(notes_of([&] { simulation = simulate(World::kManhattan, {.poses = 20000}); }),
                          20000);
  GraphFile file;
  file.graph = std::move(simulation.graph);
  std::string text;
  expect_shares_that_grow(notes_of([&] { text = format_graph(file); }), 2);
  expect_shares_that_grow(notes_of([&] { file = parse_graph(text, "test", {.threads = 2}); }), 2);
  EXPECT_EQ(file.graph.vertex_count(), 20000U);
  expect_shares_that_grow(
      notes_of([] { (void)simulate_bundle(BundleShape::kStreet, {.cameras = 10, .points = 100}); }), 100);
}

}  // namespace
}  // namespace boxplus
