// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace boxplus {

/// The bytes of main memory that this process may use, or 0 if unknown. This is the memory of the machine, or
/// less if the control group of the process (a container, a service, a batch job) has a limit. `root` is the
/// folder that contains proc and sys.
std::uint64_t physical_memory(const std::filesystem::path& root = "/");

/// Does what detail::prefer_large_pages() says (base/large_pages.h).
void use_large_pages(const void* memory, std::size_t bytes);

}  // namespace boxplus
