// SPDX-License-Identifier: BSD-3-Clause
// Large pages for large blocks of memory.
#pragma once

#include <cstddef>

#include "boxplus/base/abi.h"

namespace boxplus::detail {

/// Tells the system that all of the newly allocated memory will be used. The system may then use pages of 2
/// MiB instead of 4 KiB, which saves page faults and TLB misses. This is a hint; small blocks are ignored.
void prefer_large_pages(const void* memory, std::size_t bytes);

}  // namespace boxplus::detail
