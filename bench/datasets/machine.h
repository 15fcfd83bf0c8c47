// SPDX-License-Identifier: BSD-3-Clause
// The facts about the machine that belong to a table of times.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace boxplus::bench {

/// Lines of a table, each with a name and a value. `commit` names the sources.
std::vector<std::pair<std::string, std::string>> describe_machine(const std::string& commit);

}  // namespace boxplus::bench
