// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace boxplus::app {

/// The memory of this process in bytes, now and at most; 0 if the system does not say.
struct Memory {
  std::uint64_t now = 0, peak = 0;
};
Memory memory_of_process();

}  // namespace boxplus::app
