// SPDX-License-Identifier: BSD-3-Clause
// Counts the heap allocations of the whole program, for tests that check that a function allocates nothing.
// Link allocation_counter.cpp into the test program.
#pragma once

namespace boxplus::testing {

/// False under a sanitizer, because the sanitizer has its own allocator. In that case, skip the test.
bool allocations_are_counted();

/// The number of calls to malloc, calloc, … so far, by all threads. It includes the calls from operator new
/// and from Eigen's allocator.
long allocation_count();

}  // namespace boxplus::testing
