// SPDX-License-Identifier: BSD-3-Clause
// Fewer, larger pages for large memory.
#pragma once

#include <cstddef>

#include "boxplus/base/abi.h"

namespace boxplus {

/// Tells the system that memory that was just allocated will be used from end to end, so that it may give
/// pages of 2 MiB rather than 4 KiB: fewer page faults, fewer misses. A hint; small memory is left alone.
void prefer_large_pages(const void* memory, std::size_t bytes);

}  // namespace boxplus
