// SPDX-License-Identifier: BSD-3-Clause
#include "base/number_from_chars.h"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <cmath>
#include <system_error>

namespace boxplus {

std::from_chars_result number_from_chars(const char* begin, const char* end, double& value) {
  double number = 0;
  const auto [stop, error] = fast_float::from_chars(begin, end, number);
  if (error != std::errc()) return {stop, error};
  const char* const exponent = std::find_if(begin, stop, [](char c) { return c == 'e' || c == 'E'; });
  const bool has_digits = std::any_of(begin, exponent, [](char c) { return c >= '1' && c <= '9'; });
  // fast_float reads 1e400 as ∞, and 1e-400 as 0.
  if (has_digits && (number == 0 || std::isinf(number))) return {stop, std::errc::result_out_of_range};
  value = number;
  return {stop, std::errc()};
}

}  // namespace boxplus
