// SPDX-License-Identifier: BSD-3-Clause
#include "io/printable.h"

#include <gtest/gtest.h>

namespace boxplus {
namespace {

TEST(Printable, TextHasNoControlCharactersAndIsValidUtf8) {
  EXPECT_EQ(escaped("Größe €😀"), "Größe €😀");
  EXPECT_EQ(escaped("two\nlines\tand \x1b[31m"), "two\\nlines\\tand \\x1b[31m");
  EXPECT_EQ(escaped("\xff"), "\\xff");
}

}  // namespace
}  // namespace boxplus
