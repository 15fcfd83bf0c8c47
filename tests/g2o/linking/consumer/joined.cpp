// SPDX-License-Identifier: BSD-3-Clause
// Two copies that the loader has joined work, and the program exits cleanly.
#include <cstdio>

extern "C" double optimum_one();
extern "C" double optimum_two();

int main() {
  const double one = optimum_one(), two = optimum_two();
  std::printf("%.17g %.17g\n", one, two);
  return one > 0 && one == two ? 0 : 1;
}
