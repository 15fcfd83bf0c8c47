// SPDX-License-Identifier: BSD-3-Clause
// Load, optimise and write in a process of its own, so that its memory is its own too.
#pragma once

#include <string>
#include <vector>

namespace boxplus::bench {

struct WholeRun {
  double seconds = 0;   ///< from the beginning of main() to the end of it
  double chi2 = 0;      ///< where the optimiser ended
  double peak_mib = 0;  ///< the most memory that the process held
};

/// The most memory that this process held since it was executed; ru_maxrss remembers the process before.
double peak_mib();

/// Runs a command line of words and returns the first line that it prints. Throws std::runtime_error where
/// the process fails.
std::string output_of(const std::vector<std::string>& words);

/// What the measured processes print: the line that run_process() reads.
void print_whole_run(double seconds, double chi2);

/// Runs a command line of words and reads the line that it prints. Throws std::runtime_error where the
/// process fails.
WholeRun run_process(const std::vector<std::string>& words);

}  // namespace boxplus::bench
