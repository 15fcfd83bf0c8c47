// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/dynamic_aligned_buffer.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace {

TEST(DynamicAlignedBuffer, GrowsIfMoreElementsAreRequested) {
  g2o::dynamic_aligned_buffer<double> buffer(2);
  double* large = buffer.request(100);
  large[99] = 7;
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(large) % 16, 0U);
  EXPECT_EQ(buffer.request(3), large);
  EXPECT_EQ(buffer.request(100)[99], 7);
}

}  // namespace
