// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>

namespace boxplus {

/// The bytes of main memory that this process may use: those of the machine, or fewer if its control group (a
/// container, a service, a batch job) has a limit; 0 if unknown. `root` is the folder that contains proc and
/// sys.
std::uint64_t physical_memory(const std::filesystem::path& root = "/");

}  // namespace boxplus
