// SPDX-License-Identifier: BSD-3-Clause
// Describes the machine on which the benchmarks run.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace boxplus::bench {

/// Returns the rows of a table: pairs of a name and a value. `commit` is the commit of the sources.
std::vector<std::pair<std::string, std::string>> describe_machine(const std::string& commit);

}  // namespace boxplus::bench
