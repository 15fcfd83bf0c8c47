// SPDX-License-Identifier: BSD-3-Clause
#include "io/toro/toro_format.h"

#include <gtest/gtest.h>

namespace boxplus {
namespace {

TEST(ToroFormat, IsRecognizedByTheTagOfTheFirstElement) {
  const FileFormat toro = toro_format();
  EXPECT_TRUE(toro.recognize("VERTEX2 0 0 0 0\n"));
  EXPECT_TRUE(toro.recognize("# a comment\n\n \tEDGE3 0 1"));
  EXPECT_FALSE(toro.recognize("VERTEX_SE2 0 0 0 0\nVERTEX2 1 0 0 0\n"));
  EXPECT_FALSE(toro.recognize(" \n# VERTEX2"));
  EXPECT_FALSE(toro.recognize(""));
}

TEST(ToroFormat, IsReadOnly) {
  EXPECT_FALSE(toro_format().write);
}

}  // namespace
}  // namespace boxplus
