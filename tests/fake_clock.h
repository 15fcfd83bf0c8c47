// SPDX-License-Identifier: BSD-3-Clause
// A clock that stands still until a given number of readings. It replaces std::chrono::steady_clock in the
// whole program, so that tests of time limits do not depend on the machine. Link fake_clock.cpp.
#pragma once

namespace boxplus::testing {

/// The number of readings of the clock so far, by all threads.
long clock_readings();

/// Advances the clock by a day at the `count`-th reading (1: the next one).
void jump_at_reading(long count);

/// Lets the clock stand still again.
void stop_clock();

}  // namespace boxplus::testing
