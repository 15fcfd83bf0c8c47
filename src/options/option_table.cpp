// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/options/option_table.h"

#include <cmath>
#include <string>

#include "boxplus/base/error.h"

namespace boxplus::detail {
namespace {

bool is_in(OptionRange range, double value) {
  switch (range) {
    case OptionRange::kNotNegative:
      return value >= 0;
    case OptionRange::kFiniteNotNegative:
      return value >= 0 && std::isfinite(value);
    case OptionRange::kFraction:
      return value >= 0 && value < 1;
    default:
      return !std::isnan(value);
  }
}

/// "max_iterations ≥ 0"
std::string expected(OptionRange range, std::string_view name) {
  const std::string option(name);
  switch (range) {
    case OptionRange::kNotNegative:
      return option + " ≥ 0";
    case OptionRange::kFiniteNotNegative:
      return "a finite " + option + " ≥ 0";
    case OptionRange::kFraction:
      return "0 ≤ " + option + " < 1";
    default:
      return "a " + option + " that is a number";
  }
}

template <class T>
void check(const Option<T>& option, const Options& options) {
  const T value = options.*option.member;
  if constexpr (std::is_enum_v<T>) {
    const auto number = static_cast<std::size_t>(value);
    if (number >= OptionWords<T>::kAll.size())
      throw InvalidArgument("Options: expected one of the values of " + std::string(OptionWords<T>::kName) +
                            ", got " + std::to_string(number));
  } else if (!is_in(option.range, static_cast<double>(value))) {
    throw InvalidArgument("Options: expected " + expected(option.range, option.name));
  }
}

}  // namespace

void check_options(const Options& options) {
  std::apply([&](const auto&... option) { (check(option, options), ...); }, kOptions);
}

}  // namespace boxplus::detail

namespace boxplus {

std::string_view to_string(AlgorithmKind kind) {
  return detail::word_of(kind);
}

std::string_view to_string(Start start) {
  return detail::word_of(start);
}

}  // namespace boxplus
