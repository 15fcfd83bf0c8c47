// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/progress_notes.h"
#include "boxplus/outliers/outliers.h"
#include "boxplus/testing/simulate.h"

namespace boxplus {
namespace {

using testing::Contains;
using testing::HasSubstr;

TEST(FindOutliers, TellsItsStages) {
  SimulationOptions options{.poses = 400};
  options.outliers = 0.3;
  Simulation simulation = simulate(World::kManhattan, options);
  Graph copy = simulation.graph;
  EXPECT_THAT(notes_of([&] { (void)find_outliers(simulation.graph); }).stages,
              Contains(HasSubstr("loop closures accepted")));
  EXPECT_THAT(notes_of([&] { (void)find_outliers(copy, {.suspects = Suspects::kAll}); }).stages,
              Contains(HasSubstr("weighing the edges")));
}

}  // namespace
}  // namespace boxplus
