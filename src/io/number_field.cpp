// SPDX-License-Identifier: BSD-3-Clause
#include "io/number_field.h"

#include <fast_float/fast_float.h>

#include <cmath>
#include <cstdint>

namespace boxplus {
namespace {

/// The integer that makes up the whole field at `at`. If the field is anything else, or has more digits than
/// a double can hold exactly, the result has no `end`.
Decimal read_integer(const char* at, const char* end) {
  constexpr std::ptrdiff_t kMostDigits = 15;
  const bool negative = *at == '-';
  const char* const digits = at + negative;
  const char* digit = digits;
  std::int64_t value = 0;
  for (; digit != end && *digit >= '0' && *digit <= '9' && digit - digits < kMostDigits; ++digit) {
    value = 10 * value + (*digit - '0');
  }
  if (digit == digits || !ends_field(digit, end)) return {};
  return {negative ? -static_cast<double>(value) : static_cast<double>(value), digit, true};
}

}  // namespace

Decimal read_number_field(const char* at, const char* end) {
  if (const Decimal integer = read_integer(at, end); integer.end) return integer;
  Decimal number;
  const auto [stopped, error] = fast_float::from_chars(at, end, number.value);
  if (error == std::errc() && ends_field(stopped, end) && std::isfinite(number.value)) number.end = stopped;
  return number;
}

}  // namespace boxplus
