// SPDX-License-Identifier: BSD-3-Clause
// Describes the machine on which times are measured.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace boxplus::bench {

/// Returns the lines of a table, each with a name and a value. `commit` is the commit of the sources.
std::vector<std::pair<std::string, std::string>> describe_machine(const std::string& commit);

}  // namespace boxplus::bench
