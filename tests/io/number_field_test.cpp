// SPDX-License-Identifier: BSD-3-Clause
#include "io/number_field.h"

#include <gtest/gtest.h>

#include <string_view>

namespace boxplus {
namespace {

TEST(NumberField, IsAFiniteNumberThatFillsTheField) {
  const auto read = [](std::string_view text) {
    return read_number_field(text.data(), text.data() + text.size());
  };
  EXPECT_EQ(read("-3.859900e+02").value, -385.99);
  EXPECT_FALSE(read("-3.859900e+02").is_integer);
  EXPECT_EQ(read("12 34").value, 12);
  EXPECT_TRUE(read("-12\t").is_integer);
  EXPECT_TRUE(read("123456789012345").is_integer);
  EXPECT_FALSE(read("1234567890123456").is_integer) << "a double may not hold it exactly";
  for (const char* other : {"", "x", "1x", "nan", "inf", "1e999", "0x10", "-", "1,5"})
    EXPECT_EQ(read(other).end, nullptr) << other;
}

}  // namespace
}  // namespace boxplus
