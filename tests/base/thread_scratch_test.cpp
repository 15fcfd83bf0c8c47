// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/base/thread_scratch.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace boxplus::detail {
namespace {

using Scratch = BorrowedScratch<std::vector<int>, struct OfThisTest>;

TEST(BorrowedScratch, OfANestedScopeIsAnotherObject) {
  const Scratch outer;
  const Scratch inner;
  EXPECT_NE(&*outer, &*inner);
}

TEST(BorrowedScratch, OfALaterScopeOfTheSameDepthIsTheSameObject) {
  const auto borrow_two = [] {
    const Scratch outer, inner;
    return std::vector{&*outer, &*inner};
  };
  EXPECT_EQ(borrow_two(), borrow_two());
}

TEST(BorrowedScratch, IsGivenBackIfAnExceptionEndsTheScope) {
  const std::vector<int>* first = nullptr;
  try {
    const Scratch scratch;
    first = &*scratch;
    throw std::runtime_error("");
  } catch (const std::runtime_error&) {
  }
  EXPECT_EQ(&*Scratch(), first);
}

}  // namespace
}  // namespace boxplus::detail
