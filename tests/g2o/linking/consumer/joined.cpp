// SPDX-License-Identifier: BSD-3-Clause
// Calls two libraries with one copy of the g2o API each. The loader binds the symbols of both libraries to
// one of the copies. Both libraries must work, and the program must exit cleanly.
#include <cstdio>

extern "C" double optimum_one();
extern "C" double optimum_two();

int main() {
  const double one = optimum_one(), two = optimum_two();
  std::printf("%.17g %.17g\n", one, two);
  return one > 0 && one == two ? 0 : 1;
}
