// SPDX-License-Identifier: BSD-3-Clause
// two_copies FIRST SECOND ARE_SEPARATE: checks that two modules work at the same time, and that the second
// module still works after the first is unloaded. ARE_SEPARATE is 1 if each module must have its own factory,
// else 0.
#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>

struct Module {
  void* handle;
  double (*optimum)();
  const void* (*factory)();
};

static Module open_module(const char* path) {
  void* handle = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    std::fprintf(stderr, "%s\n", dlerror());
    std::exit(1);
  }
  return {handle, reinterpret_cast<double (*)()>(dlsym(handle, "optimum")),
          reinterpret_cast<const void* (*)()>(dlsym(handle, "factory"))};
}

int main(int count, char** words) {
  if (count != 4) return 1;
  const Module first = open_module(words[1]), second = open_module(words[2]);
  const bool separate = first.factory() != second.factory();
  const double one = first.optimum(), two = second.optimum(), again = first.optimum();
  dlclose(first.handle);
  const double alone = second.optimum();
  dlclose(second.handle);
  std::printf("%.17g %.17g %.17g %.17g separate %d\n", one, two, again, alone, separate);
  const bool same = one > 0 && one == two && one == again && one == alone;
  return same && separate == (std::atoi(words[3]) != 0) ? 0 : 1;
}
