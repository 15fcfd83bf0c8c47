// SPDX-License-Identifier: BSD-3-Clause
// Runs programs that load, optimize and write a graph. Each run is a separate process, so that its memory can
// be measured.
#pragma once

#include <string>
#include <vector>

namespace boxplus::bench {

struct WholeRun {
  double seconds = 0;   ///< the time from the beginning to the end of main()
  double chi2 = 0;      ///< chi2 at the end
  double peak_mib = 0;  ///< the peak memory of the process
};

/// Returns the peak memory of this process since exec(). (ru_maxrss would include the memory before exec().)
double peak_mib();

/// Runs the program words[0] with the arguments words[1], words[2], …. Returns the first line of its output.
/// Throws std::runtime_error if the process fails.
std::string output_of(const std::vector<std::string>& words);

/// Prints the results of this process in the form that run_process() reads.
void print_whole_run(double seconds, double chi2);

/// Calls output_of(), and parses the line. Throws std::runtime_error if the process fails.
WholeRun run_process(const std::vector<std::string>& words);

}  // namespace boxplus::bench
