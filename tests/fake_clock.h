// SPDX-License-Identifier: BSD-3-Clause
// A clock that only questions move, in place of std::chrono::steady_clock, for the whole program: so tests of
// time limits do not depend on the machine. Link fake_clock.cpp in.
#pragma once

namespace boxplus::testing {

/// Questions to the clock so far, by all threads.
long clock_questions();

/// From the `count`-th question on (1: the next one), it is a day later.
void jump_at_question(long count);

/// The clock stands still again.
void stop_clock();

}  // namespace boxplus::testing
