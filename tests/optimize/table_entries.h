// SPDX-License-Identifier: BSD-3-Clause
// Lists the entries of the library's tables, so that tests of all entries also run on a new entry.
#pragma once

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include "boxplus/algorithm/algorithm_table.h"
#include "guess/start_table.h"

namespace boxplus {

/// All algorithms except kAutomatic, which only chooses another algorithm.
inline std::vector<AlgorithmKind> every_algorithm() {
  std::vector<AlgorithmKind> kinds;
  for (const detail::AlgorithmEntry& entry : detail::algorithm_table()) {
    if (entry.make != nullptr) kinds.push_back(entry.kind);
  }
  return kinds;
}

/// All starts, with or without a guess.
inline std::vector<Start> every_start() {
  std::vector<Start> starts;
  for (const detail::StartEntry& entry : detail::start_table()) starts.push_back(entry.start);
  return starts;
}

/// The starts that make a guess.
inline std::vector<detail::StartEntry> every_guess() {
  std::vector<detail::StartEntry> guesses;
  for (const detail::StartEntry& entry : detail::start_table()) {
    if (entry.guess != nullptr) guesses.push_back(entry);
  }
  return guesses;
}

/// The name of an algorithm or a start as a part of the name of a test.
template <typename Kind>
std::string test_name(Kind kind) {
  std::string name(to_string(kind));
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

}  // namespace boxplus
