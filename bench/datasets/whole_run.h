// SPDX-License-Identifier: BSD-3-Clause
// Load, optimize and write in a separate process, so that its memory is measured separately.
#pragma once

#include <string>
#include <vector>

namespace boxplus::bench {

struct WholeRun {
  double seconds = 0;   ///< from the beginning to the end of main()
  double chi2 = 0;      ///< at the end
  double peak_mib = 0;  ///< the largest memory of the process
};

/// The largest memory of this process since exec; ru_maxrss includes the process before exec.
double peak_mib();

/// Runs a command line of words and returns the first line of its output. Throws std::runtime_error if the
/// process fails.
std::string output_of(const std::vector<std::string>& words);

/// Prints the line that run_process() reads.
void print_whole_run(double seconds, double chi2);

/// Runs a command line of words and reads the line that it prints. Throws std::runtime_error if the process
/// fails.
WholeRun run_process(const std::vector<std::string>& words);

}  // namespace boxplus::bench
