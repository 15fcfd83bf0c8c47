// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace g2o_tool {

/// Loads the libraries named, and those that match the pattern in the folders of the environment variables,
/// or, where none is set, beside the program, in ../lib and in ../lib/g2o. They register their types or
/// algorithms when they are loaded. What cannot be loaded is said on standard error.
void load_type_libraries(const std::vector<std::string>& named, const char* program);
void load_solver_libraries(const std::vector<std::string>& named, const char* program);

}  // namespace g2o_tool
