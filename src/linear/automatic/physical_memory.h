// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>

namespace boxplus {

/// Bytes of main memory that this process may use: those of the machine, or fewer where its control group (a
/// container, a service, a batch job) is limited; 0 where the system does not tell. Below `root` are proc and
/// sys.
std::uint64_t physical_memory(const std::filesystem::path& root = "/");

}  // namespace boxplus
