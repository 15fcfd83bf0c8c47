// SPDX-License-Identifier: BSD-3-Clause
#include "io/decimal.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <string>

namespace boxplus {
namespace {

/// The result of read_decimal() for `text`, followed by more text.
Decimal read(const std::string& text) {
  static std::string padded;
  padded = text + " 3.25 7" + std::string(kDecimalRoom, '9');
  Decimal number = read_decimal(padded.data());
  EXPECT_TRUE(!number.end || number.end == padded.data() + text.size()) << text;
  return number;
}

double nearest(const std::string& text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

void expect_nearest(const std::string& text) {
  const Decimal number = read(text);
  ASSERT_NE(number.end, nullptr) << text;
  EXPECT_EQ(std::bit_cast<std::uint64_t>(number.value), std::bit_cast<std::uint64_t>(nearest(text))) << text;
  EXPECT_EQ(number.is_integer, text.find('.') == std::string::npos) << text;
}

TEST(Decimal, ReadsNumbersThatGraphFilesContainToTheNearestDouble) {
  for (const char* text :
       {"0", "-0", "7", "-12", "9999999", "0.5", "-0.0", "1.0", "11.1111", "0.9893383066362528", "3.14159",
        "-0.03313281201822979", "0.000123456789012345678", "1111.111111111111", "9999999.999999999",
        "0.00000000000000000000012345", "123.4567890123456789", "1.8446744073709551615", "00012.500"}) {
    expect_nearest(text);
  }
}

TEST(Decimal, RoundsCorrectlyIfANumberIsAlmostHalfwayBetweenTwoDoubles) {
  // The texts are close to such halfway points, for example to 1 + 2^-53 = 1.00000000000000011102… and to
  // 1 - 2^-54 = 0.999999999999999944488…
  for (const char* text :
       {"1.000000000000000110", "1.000000000000000111", "1.000000000000000112", "0.999999999999999944",
        "0.999999999999999945", "0.5000000000000000555", "0.5000000000000000556", "1000.000000000000056",
        "1000.000000000000057", "1048576.000000000116", "1048576.000000000117"}) {
    expect_nearest(text);
  }
}

TEST(Decimal, HasNoEndIfTheTextIsNotADecimalNumberOrHasTooManyDigits) {
  for (const char* text :
       {"", "-", "+1", ".5", "5.", "nan", "inf", "-inf", "x", "12345678", "12345678.5",
        "0.1000000000000000055511151", "1.0000000000000000000000000001", "0.12345678901234567890123456789"}) {
    EXPECT_EQ(read(text).end, nullptr) << text;
  }
}

TEST(Decimal, EndsBeforeAnExponentOrALetter) {
  for (const char* text : {"1.5e3", "1.5x", "1.5-2", "1.5.5"}) {
    const std::string padded = text + std::string(kDecimalRoom, ' ');
    EXPECT_EQ(read_decimal(padded.data()).end, padded.data() + 3) << text;
  }
}

RC_GTEST_PROP(Decimal, IsTheNearestDoubleOfAnyRandomDigits, ()) {
  const int whole = *rc::gen::inRange(1, 8), decimals = *rc::gen::inRange(0, 20 - whole);
  std::string text = *rc::gen::element<std::string>("", "-");
  const auto append = [&](int count) {
    for (int k = 0; k < count; ++k) text += static_cast<char>('0' + *rc::gen::inRange(0, 10));
  };
  append(whole);
  if (decimals > 0) text += '.';
  append(decimals);
  expect_nearest(text);
  RC_ASSERT(!::testing::Test::HasFailure());
}

RC_GTEST_PROP(Decimal, ReadsBackRandomDoublesThatWerePrinted, (std::uint64_t bits)) {
  // A random number from 1e-5 to 1e7, printed with 17 digits, with the fewest digits, and with 12 decimals.
  const double x = (1 + std::ldexp(static_cast<double>(bits >> 12), -52)) *
                   std::pow(10.0, static_cast<int>(bits % 12) - 5);
  for (const std::string& text :
       {fmt::format("{:.17}", x), fmt::format("{}", x), fmt::format("{:.12f}", x)}) {
    if (text.find('e') == std::string::npos) expect_nearest(text);
  }
  RC_ASSERT(!::testing::Test::HasFailure());
}

}  // namespace
}  // namespace boxplus
