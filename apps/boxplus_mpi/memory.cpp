// SPDX-License-Identifier: BSD-3-Clause
#include "memory.h"

#include <fstream>
#include <string>

namespace boxplus::app {

Memory memory_of_process() {
  constexpr std::uint64_t kKilo = 1024;
  Memory memory;
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::uint64_t kilobytes = 0;
    if (word == "VmRSS:" && status >> kilobytes) memory.now = kKilo * kilobytes;
    if (word == "VmHWM:" && status >> kilobytes) memory.peak = kKilo * kilobytes;
  }
  return memory;
}

}  // namespace boxplus::app
