// SPDX-License-Identifier: BSD-3-Clause
// The assignment of fronts to threads.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace boxplus {

struct Front;
struct AmalgamationRule;

/// Disjoint subtrees, assigned to threads by predicted time. After the subtrees, the threads work together on
/// the fronts above them, one front after the other. The subtrees are chosen as in Geist and Ng, Task
/// scheduling for parallel sparse Cholesky factorization, 1989. The arithmetic of a front is the same on any
/// number of threads, so the factor does not depend on the schedule.
struct TreeSchedule {
  /// A whole subtree: the fronts [begin, end).
  struct Subtree {
    std::uint32_t begin, end;
    double time;
  };
  std::vector<std::vector<Subtree>> threads;  // empty if one thread factorizes all fronts in their order
  std::vector<std::uint32_t> top;             // the fronts above the subtrees, ascending

  bool is_parallel() const { return !threads.empty(); }
};

/// The schedule is empty if several threads are predicted to save less than a few hundred µs.
TreeSchedule make_schedule(std::span<const Front> fronts, const AmalgamationRule& rule, int threads);

}  // namespace boxplus
