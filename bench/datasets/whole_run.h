// SPDX-License-Identifier: BSD-3-Clause
// Runs programs that load, optimize and write a graph, each in its own process, so that its memory is
// measured separately.
#pragma once

#include <string>
#include <vector>

namespace boxplus::bench {

struct WholeRun {
  double seconds = 0;   ///< the time from the beginning to the end of main()
  double chi2 = 0;      ///< chi2 at the end
  double peak_mib = 0;  ///< the largest memory of the process
};

/// Returns the largest memory of this process since exec(). Unlike ru_maxrss, it does not include the memory
/// before exec().
double peak_mib();

/// Runs the command line that consists of these words, and returns the first line of its output. Throws
/// std::runtime_error if the process fails.
std::string output_of(const std::vector<std::string>& words);

/// Prints the line that run_process() reads.
void print_whole_run(double seconds, double chi2);

/// Runs the command line that consists of these words, and reads the line that it prints. Throws
/// std::runtime_error if the process fails.
WholeRun run_process(const std::vector<std::string>& words);

}  // namespace boxplus::bench
