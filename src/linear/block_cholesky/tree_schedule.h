// SPDX-License-Identifier: BSD-3-Clause
// The assignment of fronts to threads.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace boxplus {

struct Front;
struct AmalgamationRule;

/// Disjoint subtrees, assigned to threads by predicted time. The fronts above them follow, one by one, each
/// on all threads. The subtrees are chosen as in Geist and Ng, Task scheduling for parallel sparse Cholesky
/// factorization, 1989. The arithmetic of a front is the same on every thread, so the factor does not depend
/// on the schedule.
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

/// The schedule is empty if the whole factorization is predicted to take less than a few hundred µs.
TreeSchedule make_schedule(std::span<const Front> fronts, const AmalgamationRule& rule, int threads);

}  // namespace boxplus
