// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace g2o_tool {

/// Loads the libraries in `named`, and all libraries in the plug-in folders whose file names contain
/// "_types_" or "_solver_". The environment variables list the plug-in folders. If no variable is set, the
/// plug-in folders are the folder of the program, ../lib and ../lib/g2o. Libraries register their types or
/// algorithms when they are loaded. Prints a message to standard error for each library that cannot be
/// loaded.
void load_type_libraries(const std::vector<std::string>& named, const char* program);
void load_solver_libraries(const std::vector<std::string>& named, const char* program);

}  // namespace g2o_tool
