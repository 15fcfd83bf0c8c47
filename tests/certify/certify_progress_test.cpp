// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/progress_notes.h"
#include "boxplus/certify/certificate.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/testing/simulate.h"

namespace boxplus {
namespace {

TEST(Certify, TellsItsSteps) {
  Graph graph = simulate(World::kManhattan, {.poses = 400}).graph;
  (void)optimize(graph);
  EXPECT_THAT(notes_of([&] { (void)certify(graph); }).stages, testing::Contains(testing::HasSubstr("step ")));
}

}  // namespace
}  // namespace boxplus
