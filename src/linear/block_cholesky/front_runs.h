// SPDX-License-Identifier: BSD-3-Clause
// Finds runs: ranges of consecutive rows that have consecutive destinations, so that they are moved together.
#pragma once

#include "linear/block_cholesky/symbolic_factor.h"

namespace boxplus {

/// Appends `run` to the list of runs that starts at `begin`. If `run` continues the last run of this list in
/// both the source and the destination, extends the last run instead.
inline void append_run(std::vector<ScalarRun>& runs, std::uint32_t begin, const ScalarRun& run) {
  constexpr std::uint32_t kLongest = 64;  // short enough to divide the runs evenly among threads
  if (runs.size() > begin && runs.back().length < kLongest &&
      runs.back().source + runs.back().length == run.source &&
      runs.back().destination + runs.back().length == run.destination) {
    runs.back().length += run.length;
  } else {
    runs.push_back(run);
  }
}

/// Lists the runs of rows of the child's update matrix, with their destinations in the parent's front.
/// local(row) returns the index of the first scalar of block `row` in the parent's front.
template <class Local>
void find_runs(SymbolicFactor& f, Front& child, const Front& parent, Local&& local) {
  child.run_begin = child.run_split = static_cast<std::uint32_t>(f.runs.size());
  std::uint32_t source = 0, begin = child.run_begin;
  for (const std::uint32_t row : f.rows(child)) {
    const auto end = static_cast<std::uint32_t>(f.runs.size());
    if (row >= parent.end_block && begin == child.run_begin) begin = child.run_split = end;
    append_run(f.runs, begin, {source, local(row), f.dim(row)});
    source += f.dim(row);
    if (row < parent.end_block) child.run_split = static_cast<std::uint32_t>(f.runs.size());
  }
  child.run_end = static_cast<std::uint32_t>(f.runs.size());
}

}  // namespace boxplus
