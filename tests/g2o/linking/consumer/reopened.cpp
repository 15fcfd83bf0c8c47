// SPDX-License-Identifier: BSD-3-Clause
// reopened FOLDER: loads the shared libraries of the g2o API in FOLDER, and unloads libraries of types in
// several orders while others remain. What a library has declared must not refer to it afterwards.
#include <dlfcn.h>

#include <cstdio>
#include <string>

static void* open_types(const std::string& folder, const char* name) {
  void* library = dlopen((folder + "/libg2o_" + name + ".so").c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) std::fprintf(stderr, "%s\n", dlerror());
  return library;
}

int main(int count, char** words) {
  if (count != 2) return 1;
  if (open_types(words[1], "core") == nullptr) return 1;
  for (const char* const second : {"types_sim3", "types_slam3d", "types_sba", "types_icp", "types_slam2d"}) {
    void* first = open_types(words[1], "types_sba");
    if (first == nullptr) return 1;
    dlclose(first);
    void* other = open_types(words[1], second);
    if (other == nullptr) return 1;
    dlclose(other);
  }
  return 0;
}
