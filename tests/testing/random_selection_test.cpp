// SPDX-License-Identifier: BSD-3-Clause
#include "testing/random_selection.h"

#include <gtest/gtest.h>

namespace boxplus {
namespace {

TEST(RandomSelection, TakesEachElementWithTheSameChance) {
  constexpr int kSequences = 100'000, kLength = 5;
  for (const double chance : {0.01, 0.3, 0.9}) {
    RandomNumbers random(1);
    int taken[kLength] = {};
    for (int k = 0; k < kSequences; ++k) {
      RandomSelection selection(chance, random);
      for (int& count : taken) count += selection.takes_next();
    }
    // A binomial variable has mean np and variance np(1 − p).
    for (const int count : taken)
      EXPECT_NEAR(count, kSequences * chance, 4 * std::sqrt(kSequences * chance * (1 - chance)));
  }
}

TEST(RandomSelection, TakesAllElementsIfTheChanceIsOne) {
  RandomNumbers random(1);
  RandomSelection selection(1, random);
  for (int k = 0; k < 1000; ++k) EXPECT_TRUE(selection.takes_next());
}

}  // namespace
}  // namespace boxplus
