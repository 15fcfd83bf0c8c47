// SPDX-License-Identifier: BSD-3-Clause
#include "io/g2o/g2o_format.h"

#include <gtest/gtest.h>

namespace boxplus {
namespace {

TEST(G2oFormat, RecognizesAnyText) {
  EXPECT_TRUE(g2o_format().recognize(""));
  EXPECT_TRUE(
      g2o_format().recognize("\x7f"
                             "ELF"));
}

}  // namespace
}  // namespace boxplus
