// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace boxplus {

/// Bytes of main memory of this machine; 0 where the system does not tell.
std::uint64_t physical_memory();

}  // namespace boxplus
