// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/base/large_pages.h"

#include "platform/memory.h"

namespace boxplus::detail {

void prefer_large_pages(const void* memory, std::size_t bytes) {
  use_large_pages(memory, bytes);
}

}  // namespace boxplus::detail
