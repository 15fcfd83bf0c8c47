// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/base/large_pages.h"

#if defined(__linux__)
#include <sys/mman.h>
#endif

#include <cerrno>
#include <cstdint>

namespace boxplus::detail {

void prefer_large_pages([[maybe_unused]] const void* memory, [[maybe_unused]] std::size_t bytes) {
#if defined(MADV_HUGEPAGE)
  // Rounds the range inward to whole large pages, because other objects may use the rest of the first and the
  // last page.
  constexpr std::uintptr_t kPage = std::uintptr_t{1} << 21;
  const auto address = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t begin = (address + kPage - 1) / kPage * kPage, end = (address + bytes) / kPage * kPage;
  if (begin >= end) return;
  const int error = errno;  // restored below, because a system without large pages is not an error
  madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
  errno = error;
#endif
}

}  // namespace boxplus::detail
