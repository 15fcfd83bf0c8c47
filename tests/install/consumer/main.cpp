// SPDX-License-Identifier: BSD-3-Clause
// The smallest program that links the library.
#include <boxplus/base/parallel.h>

#include <atomic>

static_assert(EIGEN_MAX_ALIGN_BYTES == 16, "boxplus::boxplus passes its definitions on");

int main() {
  std::atomic<int> sum{0};
  boxplus::parallel_tasks(4, [&](int i) { sum += i; });
  return sum == 6 ? 0 : 1;
}
