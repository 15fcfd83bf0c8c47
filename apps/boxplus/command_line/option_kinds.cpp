// SPDX-License-Identifier: BSD-3-Clause
#include "command_line/option_kinds.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "settings/parse_number.h"

namespace boxplus::app {
namespace {

template <class Accept>
CLI::Validator number_check(std::string expected, Accept accept) {
  const auto check = [expected = std::move(expected), accept](const std::string& text) {
    double value = 0;
    const bool good = parse_number(text, value) && std::isfinite(value) && accept(value);
    return good ? std::string() : fmt::format("expected {}, got '{}'", expected, text);
  };
  return {check, ""};
}

}  // namespace

CLI::Validator one_of(std::vector<std::string> words) {
  std::string description = fmt::format("{{{}}}", fmt::join(words, ","));
  const auto check = [words = std::move(words)](const std::string& text) {
    if (std::find(words.begin(), words.end(), text) != words.end()) return std::string();
    return fmt::format("expected one of {}, got '{}'", fmt::join(words, ", "), text);
  };
  return {check, description};
}

CLI::Validator file_name() {
  const auto check = [](const std::string& text) {
    return text.empty() ? std::string("expected the name of a file, got ''") : std::string();
  };
  return {check, ""};
}

CLI::Validator whole_number_from(long low) {
  const auto check = [low](const std::string& text) {
    constexpr long kMost = std::numeric_limits<int>::max();
    long value = 0;
    const bool is_number = parse_number(text, value);
    if (is_number && value >= low && value <= kMost) return std::string();
    return is_number && value > kMost ? fmt::format("expected a whole number ≤ {}, got '{}'", kMost, text)
                                      : fmt::format("expected a whole number ≥ {}, got '{}'", low, text);
  };
  return {check, ""};
}

CLI::Validator whole_number_within(long low, long high) {
  const bool is_bounded = high < std::numeric_limits<long>::max();
  std::string range = is_bounded ? fmt::format("from {} to {}", low, high) : fmt::format("≥ {}", low);
  const auto check = [low, high, range = std::move(range)](const std::string& text) {
    long value = 0;
    const bool good = parse_number(text, value) && value >= low && value <= high;
    return good ? std::string() : fmt::format("expected a whole number {}, got '{}'", range, text);
  };
  return {check, ""};
}

CLI::Validator number_within(double low, double high) {
  return number_check(fmt::format("a number from {} to {}", low, high),
                      [low, high](double value) { return value >= low && value <= high; });
}

CLI::Validator number_from(double low) {
  return number_check(fmt::format("a number ≥ {}", low), [low](double value) { return value >= low; });
}

CLI::Validator number_above(double low) {
  return number_check(fmt::format("a number > {}", low), [low](double value) { return value > low; });
}

}  // namespace boxplus::app
