// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/base/progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "base/progress_notes.h"

namespace boxplus {
namespace {

using testing::ElementsAre;

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
  EXPECT_THAT(inner.stages, ElementsAre("half"));
  EXPECT_THAT(outer.shares, ElementsAre(0.5, 0.5));
}

}  // namespace
}  // namespace boxplus
