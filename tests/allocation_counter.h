// SPDX-License-Identifier: BSD-3-Clause
// Counts the heap allocations of the whole program, for tests of "allocates nothing". Link
// allocation_counter.cpp in.
#pragma once

namespace boxplus::testing {

/// False under a sanitizer, which has an allocator of its own: then skip the test.
bool allocations_are_counted();

/// Number of calls so far of malloc and its kin, so also of operator new and of Eigen's allocator, by all
/// threads.
long allocation_count();

}  // namespace boxplus::testing
