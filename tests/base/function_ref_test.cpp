// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/base/function_ref.h"

#include <gtest/gtest.h>

#include <memory>
#include <type_traits>
#include <utility>

namespace boxplus {
namespace {

TEST(FunctionRef, CallsTheOriginalFunctionObjectAndNotACopy) {
  int calls = 0;
  auto count = [calls]() mutable { return ++calls; };
  const detail::FunctionRef<int()> reference = count;
  reference();
  EXPECT_EQ(count(), 2);
}

TEST(FunctionRef, CallsConstCallables) {
  const auto twice = [](int x) { return 2 * x; };
  EXPECT_EQ(detail::FunctionRef<int(int)>(twice)(21), 42);
}

TEST(FunctionRef, ForwardsReferencesAndMoveOnlyArguments) {
  auto store = [](std::unique_ptr<int> from, int& to) { to = *from; };
  const detail::FunctionRef<void(std::unique_ptr<int>, int&)> reference = store;
  int value = 0;
  reference(std::make_unique<int>(7), value);
  EXPECT_EQ(value, 7);
}

TEST(FunctionRef, IsAsLargeAsTwoPointersAndTriviallyCopyable) {
  EXPECT_EQ(sizeof(detail::FunctionRef<void(int)>), 2 * sizeof(void*));
  EXPECT_TRUE(std::is_trivially_copyable_v<detail::FunctionRef<void(int)>>);
}

}  // namespace
}  // namespace boxplus
