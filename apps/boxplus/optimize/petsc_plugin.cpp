// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/petsc_plugin.h"

#include <fmt/format.h>

#include <filesystem>

#include "boxplus/base/error.h"
#include "io/printable.h"
#include "platform/process.h"

namespace boxplus::app {
namespace {

namespace fs = std::filesystem;

/// The plug-in in a folder for libraries beside the folder of the program, or an empty path.
fs::path find_plugin() {
  std::error_code error;
  const fs::path above = program_path().parent_path().parent_path();
  for (const char* folder : {"lib", BOXPLUS_LIBRARY_FOLDER}) {
    fs::path path = above / folder / "boxplus" / "boxplus_petsc.so";
    if (fs::exists(path, error)) return path;
  }
  return {};
}

}  // namespace

void* find_in_petsc_plugin(const char* function) {
  const fs::path path = find_plugin();
  if (path.empty())
    throw InvalidArgument(
        "--petsc: this boxplus was built without PETSc; install the packages of "
        "scripts/debian-packages-mpi.txt, and build it again");
  // Never closed, because PETSc ends when the program exits.
  std::string error;
  void* const found = load_function(path.string(), function, error);
  if (found == nullptr)
    throw FileError(fmt::format("{} cannot be loaded: {}", escaped(path.string()), escaped(error)));
  return found;
}

std::shared_ptr<LinearSolver> load_petsc_solver(const std::string& options) {
  void* const make = find_in_petsc_plugin("boxplus_petsc_solver");
  return std::shared_ptr<LinearSolver>(
      reinterpret_cast<LinearSolver* (*)(const char*)>(make)(options.c_str()));
}

}  // namespace boxplus::app
