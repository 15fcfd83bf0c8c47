// SPDX-License-Identifier: BSD-3-Clause
// A clock that stands still until it has been read a given number of times. It replaces
// std::chrono::steady_clock in the whole program, so that tests of time limits do not depend on the machine.
// Link fake_clock.cpp into the test program.
#pragma once

namespace boxplus::testing {

/// The number of readings of the clock so far, by all threads.
long clock_readings();

/// Advances the clock by a day at the `count`-th reading from now (1: the next reading).
void jump_at_reading(long count);

/// Cancels the jump, so that the clock stands still again.
void stop_clock();

}  // namespace boxplus::testing
