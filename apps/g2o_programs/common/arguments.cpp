// SPDX-License-Identifier: BSD-3-Clause
#include "common/arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace boxplus::programs {

void Arguments::text(const char* name, std::string& value, const char* text) {
  const std::string initial = value;
  args_.param(name, value, initial, text);
}

void Arguments::count(const char* name, int& value, int least, int most, const char* text) {
  args_.param(name, value, int{value}, text);
  checks_.emplace_back(name, [&value, least, most]() -> std::string {
    if (value >= least && value <= most) return {};
    return fmt::format("expected an integer from {} to {}, got {}", least, most, value);
  });
}

void Arguments::number(const char* name, double& value, double least, double most, const char* text) {
  args_.param(name, value, double{value}, text);
  checks_.emplace_back(name, [&value, least, most]() -> std::string {
    if (value >= least && value <= most) return {};
    return fmt::format("expected a number from {} to {}, got {}", least, most, value);
  });
}

void Arguments::numbers(const char* name, std::vector<double>& values, double least, double most,
                        const char* text) {
  const std::vector<double> initial = values;
  args_.param(name, values, initial, text);
  const auto in_range = [least, most](double value) { return value >= least && value <= most; };
  checks_.emplace_back(name, [&values, count = initial.size(), in_range, least, most]() -> std::string {
    if (values.size() == count && std::all_of(values.begin(), values.end(), in_range)) return {};
    return fmt::format("expected {} numbers from {} to {}, got {}", count, least, most,
                       fmt::join(values, ","));
  });
}

void Arguments::positional(const char* name, std::string& value, const char* text) {
  const std::string initial = value;
  args_.paramLeftOver(name, value, initial, text, true);
}

void Arguments::parse(int argc, char** argv) {
  args_.parseArgs(argc, argv);
  for (const auto& [name, check] : checks_) {
    const std::string complaint = check();
    if (complaint.empty()) continue;
    fmt::print(stderr, "parameter -{}: {}\n", name, complaint);
    std::exit(EXIT_FAILURE);
  }
}

}  // namespace boxplus::programs
