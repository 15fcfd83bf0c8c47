// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/base/error.h"

#include <gmock/gmock.h>

#include <type_traits>

namespace boxplus {
namespace {

TEST(InputError, ReportsFileLineAndColumnLikeACompiler) {
  const InputError error("loop.g2o", 12, 7, "expected a number, got 'x'");
  EXPECT_STREQ(error.what(), "loop.g2o:12:7: expected a number, got 'x'");
  EXPECT_EQ(error.line(), 12);
  EXPECT_EQ(error.column(), 7);
}

TEST(Error, IsTheBaseOfAllExceptionsAndDerivesFromRuntimeError) {
  EXPECT_THROW(throw InputError("a", 1, 1, "b"), Error);
  EXPECT_THROW(throw InvalidArgument("b"), Error);
  EXPECT_THROW(throw FileError("b"), Error);
  EXPECT_THROW(throw Error("b"), std::runtime_error);
}

TEST(Error, IsCopiedWithoutThrowing) {
  EXPECT_TRUE(std::is_nothrow_copy_constructible_v<Error>);
  EXPECT_TRUE(std::is_nothrow_copy_constructible_v<InvalidArgument>);
  EXPECT_TRUE(std::is_nothrow_copy_constructible_v<InputError>);
  EXPECT_TRUE(std::is_nothrow_copy_constructible_v<FileError>);
}

}  // namespace
}  // namespace boxplus
