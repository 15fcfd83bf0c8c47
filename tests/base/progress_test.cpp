// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/base/progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

#include "boxplus/certify/certificate.h"
#include "boxplus/io/graph_file.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/outliers/outliers.h"
#include "boxplus/testing/simulate.h"
#include "boxplus/testing/simulate_bundle.h"

namespace boxplus {
namespace {

using testing::AllOf;
using testing::Each;
using testing::Ge;
using testing::HasSubstr;
using testing::Le;
using testing::SizeIs;

/// What a call tells.
struct Notes {
  std::vector<std::string> stages;
  std::vector<double> shares;
};

template <class F>
Notes notes_of(F&& f) {
  Notes notes;
  const ProgressWatch watch([&](std::string_view stage, double share) {
    notes.stages.emplace_back(stage);
    notes.shares.push_back(share);
  });
  f();
  return notes;
}

void expect_shares_that_grow(const Notes& notes, std::size_t least) {
  EXPECT_THAT(notes.shares, SizeIs(Ge(least)));
  EXPECT_TRUE(std::is_sorted(notes.shares.begin(), notes.shares.end()));
  EXPECT_THAT(notes.shares, Each(AllOf(Ge(0), Le(1))));
}

TEST(ProgressWatch, OfThisThreadIsToldTheNewestFirst) {
  const auto note = [] { detail::note_progress(0.5, "half"); };
  note();
  EXPECT_FALSE(detail::is_watched());
  Notes inner;
  const Notes outer = notes_of([&] {
    note();
    inner = notes_of(note);
    std::thread(note).join();
    note();
  });
  EXPECT_THAT(inner.stages, testing::ElementsAre("half"));
  EXPECT_THAT(outer.shares, testing::ElementsAre(0.5, 0.5));
}

TEST(ProgressWatch, SeesHowFarReadingWritingAndSimulatingHaveCome) {
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

TEST(ProgressWatch, SeesTheStagesOfSearches) {
  SimulationOptions options{.poses = 400};
  options.outliers = 0.3;
  Simulation simulation = simulate(World::kManhattan, options);
  Graph copy = simulation.graph;
  EXPECT_THAT(notes_of([&] { (void)find_outliers(simulation.graph); }).stages,
              testing::Contains(HasSubstr("loop closures accepted")));
  const Notes all = notes_of([&] { (void)find_outliers(copy, {.suspects = Suspects::kAll}); });
  EXPECT_THAT(all.stages, testing::Contains(HasSubstr("weighing the edges")));
  Graph clean = simulate(World::kManhattan, {.poses = 400}).graph;
  (void)optimize(clean);
  EXPECT_THAT(notes_of([&] { (void)certify(clean); }).stages, testing::Contains(HasSubstr("step ")));
}

}  // namespace
}  // namespace boxplus
