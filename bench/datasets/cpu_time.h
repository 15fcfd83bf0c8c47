// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ctime>

namespace boxplus::bench {

/// The CPU time of all threads of this process, in seconds. Other processes do not disturb it.
inline double cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace boxplus::bench
