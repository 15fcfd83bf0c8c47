// SPDX-License-Identifier: BSD-3-Clause
#include "base/number_from_chars.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string_view>
#include <system_error>

namespace boxplus {
namespace {

struct Read {
  double value = -1;
  std::size_t length = 0;
  std::errc error = {};
};

Read read(std::string_view text) {
  Read read;
  const auto [stop, error] = number_from_chars(text.data(), text.data() + text.size(), read.value);
  return {read.value, static_cast<std::size_t>(stop - text.data()), error};
}

TEST(NumberFromChars, ReadsANumberUpToWhatIsNoPartOfIt) {
  EXPECT_EQ(read("-1.25e2").value, -125);
  EXPECT_EQ(read("0.0").value, 0);
  EXPECT_EQ(read("4e-324").error, std::errc());
  EXPECT_EQ(read("7x").value, 7);
  EXPECT_EQ(read("7x").length, 1U);
}

TEST(NumberFromChars, ReadsInfinityAndNaN) {
  EXPECT_TRUE(std::isinf(read("-inf").value));
  EXPECT_TRUE(std::isnan(read("nan").value));
}

TEST(NumberFromChars, RefusesTextWithoutANumber) {
  for (const char* text : {"", " 1", "+1", "-", "e5"}) {
    EXPECT_EQ(read(text).error, std::errc::invalid_argument) << text;
    EXPECT_EQ(read(text).value, -1) << text;
  }
}

TEST(NumberFromChars, RefusesNumbersThatADoubleCannotHold) {
  for (const char* text : {"1e400", "-1e400", "1e-400", "0.01e-323"}) {
    EXPECT_EQ(read(text).error, std::errc::result_out_of_range) << text;
    EXPECT_EQ(read(text).value, -1) << text;
    EXPECT_EQ(read(text).length, std::string_view(text).size()) << text;
  }
}

}  // namespace
}  // namespace boxplus
