// SPDX-License-Identifier: BSD-3-Clause
// What a table of times must say about where it was made.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace boxplus::bench {

/// Lines of a table: what, and its value. `commit` names the sources.
std::vector<std::pair<std::string, std::string>> describe_machine(const std::string& commit);

}  // namespace boxplus::bench
