// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/testing/check_jacobians.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace boxplus::detail {

void compare_jacobians(std::span<const double> expected, std::span<const double> actual, int rows,
                       double tolerance, std::span<const ArgumentColumns> arguments, std::string_view pair,
                       JacobianCheck& check) {
  double scale = 1;
  for (double entry : expected) scale = std::max(scale, std::abs(entry));
  for (std::size_t k = 0; k < arguments.size(); ++k) {
    const auto first = static_cast<std::size_t>(arguments[k].first * rows);
    const auto last = first + static_cast<std::size_t>(arguments[k].count * rows);
    std::size_t worst = first;
    double largest = -1;
    for (std::size_t i = first; i < last; ++i) {
      double difference = std::abs(expected[i] - actual[i]) / scale;
      if (!std::isfinite(difference)) difference = std::numeric_limits<double>::infinity();
      if (difference > largest) {
        largest = difference;
        worst = i;
      }
    }
    check.largest_difference = std::max(check.largest_difference, largest);
    if (largest <= tolerance) continue;
    check.ok = false;
    check.message += fmt::format("∂e/∂x_{} ({}), row {}, column {}: expected {}, got {} ({})\n", k + 1,
                                 arguments[k].type, (worst - first) % static_cast<std::size_t>(rows) + 1,
                                 (worst - first) / static_cast<std::size_t>(rows) + 1, expected[worst],
                                 actual[worst], pair);
  }
}

}  // namespace boxplus::detail
