// SPDX-License-Identifier: BSD-3-Clause
#include "io/pipeline.h"

#include <gmock/gmock.h>

#include <vector>

namespace boxplus {
namespace {

TEST(Pipeline, ConsumesItemsInOrderWithAnyNumberOfThreads) {
  for (const int threads : {1, 2, 3}) {
    for (const std::size_t count : {0u, 1u, 5u, 100u}) {
      std::vector<std::size_t> consumed, expected;
      prepare_and_consume<std::size_t>(
          count, threads, [](std::size_t k, std::size_t& item) { item = k; },
          [&](std::size_t item) { consumed.push_back(item); });
      for (std::size_t k = 0; k < count; ++k) expected.push_back(k);
      EXPECT_EQ(consumed, expected);
    }
  }
}

}  // namespace
}  // namespace boxplus
