// SPDX-License-Identifier: BSD-3-Clause
#include "plugins.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <sstream>

#include "io/printable.h"

namespace g2o_tool {
namespace {

namespace fs = std::filesystem;

/// Loads a library and never unloads it, because the types that it registers use its code. If `path` contains
/// no folder, loads the file of this name in the current folder. If there is no such file, the dynamic loader
/// searches for the library.
void load(const std::string& path) {
  if (path.empty()) {
    std::cerr << "g2o: expected the file name of a library, got an empty name\n";
    return;
  }
  std::error_code error;
  const bool is_here = path.find('/') == std::string::npos && fs::exists(path, error);
  if (dlopen((is_here ? "./" + path : path).c_str(), RTLD_NOW | RTLD_LOCAL) == nullptr)
    std::cerr << "g2o: " << boxplus::escaped(path) << " cannot be loaded: " << boxplus::escaped(dlerror())
              << '\n';
}

/// Returns the folders that the environment variables list, separated by colons. Prints a message for each
/// folder that does not exist.
std::vector<std::string> named_folders(const std::vector<const char*>& variables) {
  std::vector<std::string> result;
  std::error_code error;
  for (const char* variable : variables) {
    const char* value = std::getenv(variable);
    std::istringstream in(value == nullptr ? "" : value);
    for (std::string folder; std::getline(in, folder, ':');) {
      if (folder.empty()) continue;
      if (!fs::is_directory(folder, error))
        std::cerr << "g2o: " << variable << ": there is no folder " << boxplus::escaped(folder) << '\n';
      result.push_back(folder);
    }
  }
  return result;
}

std::vector<std::string> folders_beside(const char* program) {
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  const fs::path folder = (error ? fs::path(program) : self).parent_path();
  const fs::path above = folder / "..";
  std::vector<std::string> result = {folder.string()};
  for (const fs::path library : {"lib", G2O_LIBRARY_FOLDER}) {
    for (const fs::path& candidate : {above / library, above / library / "g2o"}) {
      const bool is_new = std::find(result.begin(), result.end(), candidate.string()) == result.end();
      if (is_new) result.push_back(candidate.string());
    }
  }
  return result;
}

/// True if the tool links the library, or if the subfolder g2o is searched for plug-ins and contains a file
/// of the same name.
bool is_known(const fs::path& library, const std::vector<std::string>& folders) {
  std::istringstream linked(G2O_LINKED_LIBRARIES);
  const std::string name = library.stem().string();
  for (std::string one; linked >> one;) {
    if (name == "lib" + one) return true;
  }
  const fs::path plugins = library.parent_path() / "g2o";
  std::error_code error;
  return fs::exists(plugins / library.filename(), error) &&
         std::find(folders.begin(), folders.end(), plugins.string()) != folders.end();
}

/// Returns the folders that the environment variables list. If no variable is set, returns the folders near
/// the program.
std::vector<std::string> folders(const std::vector<const char*>& variables, const char* program) {
  const bool is_set = std::any_of(variables.begin(), variables.end(),
                                  [](const char* variable) { return std::getenv(variable) != nullptr; });
  return is_set ? named_folders(variables) : folders_beside(program);
}

void load_matching(const std::vector<std::string>& named, const std::vector<std::string>& in_folders,
                   const std::string& pattern) {
  for (const std::string& path : named) load(path);
  for (const std::string& folder : in_folders) {
    std::error_code error;
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
      const std::string name = entry.path().filename().string();
      if (name.find(pattern) != std::string::npos && entry.path().extension() == ".so" &&
          !is_known(entry.path(), in_folders))
        found.push_back(entry.path().string());
    }
    std::sort(found.begin(), found.end());
    for (const std::string& path : found) load(path);
  }
}

}  // namespace

void load_type_libraries(const std::vector<std::string>& named, const char* program) {
  load_matching(named, folders({"G2O_TYPES_DIR"}, program), "_types_");
}

void load_solver_libraries(const std::vector<std::string>& named, const char* program) {
  load_matching(named, folders({"G2O_SOLVER_DIR", "G2O_SOLVERS_DIR"}, program), "_solver_");
}

}  // namespace g2o_tool
