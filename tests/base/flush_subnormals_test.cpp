// SPDX-License-Identifier: BSD-3-Clause
#include "base/flush_subnormals.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "boxplus/base/parallel.h"

namespace boxplus {
namespace {

/// Half of the smallest normal number.
float half_of_smallest() {
  volatile float smallest = std::numeric_limits<float>::min();
  return smallest * 0.5f;
}

TEST(FlushSubnormals, MakesThemZeroOnAllThreadsAsLongAsItExists) {
  std::array<float, 3> before{}, during{}, after{};
  const auto compute = [](std::array<float, 3>& values) {
    detail::parallel_tasks(3, [&](int i) { values[static_cast<std::size_t>(i)] = half_of_smallest(); });
  };
  compute(before);
  {
    const FlushSubnormals flush;
    compute(during);
  }
  compute(after);
  for (const float value : before) EXPECT_GT(value, 0);
#if defined(__SSE2__) || defined(__aarch64__)
  for (const float value : during) EXPECT_EQ(value, 0);
#endif
  for (const float value : after) EXPECT_GT(value, 0);
}

}  // namespace
}  // namespace boxplus
