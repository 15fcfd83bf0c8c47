// SPDX-License-Identifier: BSD-3-Clause
// Which fronts are factorized by which thread.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace boxplus {

struct Front;
struct AmalgamationRule;

/// Disjoint subtrees, shared out to the threads by predicted time; the fronts above them come afterwards, one
/// by one, each on all threads. Which they are: Geist and Ng, Task scheduling for parallel sparse Cholesky
/// factorization, 1989. A front's arithmetic is the same wherever it is done, so that the factor does not
/// depend on the schedule.
struct TreeSchedule {
  /// A whole subtree: the fronts [begin, end).
  struct Subtree {
    std::uint32_t begin, end;
    double time;
  };
  std::vector<std::vector<Subtree>> threads;  // empty: one thread does all fronts in their order
  std::vector<std::uint32_t> top;             // ascending

  bool is_parallel() const { return !threads.empty(); }
};

/// No thread gets work where the whole factorization is predicted to take less than a few hundred µs.
TreeSchedule make_schedule(std::span<const Front> fronts, const AmalgamationRule& rule, int threads);

}  // namespace boxplus
