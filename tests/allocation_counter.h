// SPDX-License-Identifier: BSD-3-Clause
// Counts the heap allocations of the whole program, for tests of "allocates nothing". Link
// allocation_counter.cpp in.
#pragma once

namespace boxplus::testing {

/// False under a sanitizer, because that has its own allocator. Then skip the test.
bool allocations_are_counted();

/// The number of calls of malloc, calloc and the like so far, by all threads. Operator new and Eigen's
/// allocator call them too.
long allocation_count();

}  // namespace boxplus::testing
