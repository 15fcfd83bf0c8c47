// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace g2o_tool {

/// Loads the named libraries, and those in plug-in folders whose names match the pattern. The folders are
/// those of the environment variables or, if none is set, the program's, ../lib and ../lib/g2o. Libraries
/// register their types or algorithms when they are loaded. Prints a message on standard error for each that
/// cannot be loaded.
void load_type_libraries(const std::vector<std::string>& named, const char* program);
void load_solver_libraries(const std::vector<std::string>& named, const char* program);

}  // namespace g2o_tool
