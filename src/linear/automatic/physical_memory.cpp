// SPDX-License-Identifier: BSD-3-Clause
#include "linear/automatic/physical_memory.h"

#include <unistd.h>

namespace boxplus {

std::uint64_t physical_memory() {
  const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGESIZE);
  if (pages <= 0 || page <= 0) return 0;
  return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page);
}

}  // namespace boxplus
