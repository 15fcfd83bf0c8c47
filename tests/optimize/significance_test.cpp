// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/significance.h"

#include <gtest/gtest.h>

#include <cmath>

namespace boxplus {
namespace {

/// The record of an iteration that decreases chi2 = 1000 by the given fraction.
IterationRecord gain_of(double fraction) {
  IterationRecord record;
  record.chi2 = 1000;
  record.chi2_decrease = record.predicted_decrease = 1000 * fraction;
  return record;
}

/// The number of iterations until is_lost() returns true, or `most` + 1. The relative decreases of chi2 are
/// first, first · q, first · q² …
int iterations_until_lost(double first, double q, double tolerance, double degrees_of_freedom, int most) {
  Significance significance(tolerance, degrees_of_freedom, 1000);
  for (int k = 0; k < most; ++k) {
    if (significance.is_lost(gain_of(first * std::pow(q, k)))) return k + 1;
  }
  return most + 1;
}

TEST(Significance, IsLostAfterTwoDecreasesBelowTheNoise) {
  // The limit is 0.02 s² = 0.02 · 1000 / 1e6, which is 2e-8 of chi2.
  Significance significance(0.02, 1e6, 1000);
  EXPECT_FALSE(significance.is_lost(gain_of(1e-3)));
  EXPECT_FALSE(significance.is_lost(gain_of(1.9e-8)));
  EXPECT_TRUE(significance.is_lost(gain_of(1e-9)));
}

TEST(Significance, IsLostEarlierIfThereAreVeryManyUnknowns) {
  // The limit is 0.02 s² · 5e6 / 1e5 = 1000 / 1e8, which is 1e-8 of chi2.
  Significance significance(0.02, 1e8, 5e6);
  EXPECT_FALSE(significance.is_lost(gain_of(1e-3)));
  EXPECT_FALSE(significance.is_lost(gain_of(1.1e-8)));
  EXPECT_FALSE(significance.is_lost(gain_of(0.9e-8)));
  EXPECT_TRUE(significance.is_lost(gain_of(0.8e-8)));
}

TEST(Significance, IsNotLostByDecreasesAboveAFixedFractionOfChi2) {
  Significance significance(0.02, 10, 1000);  // few measurements, so s² is large
  EXPECT_FALSE(significance.is_lost(gain_of(1e-3)));
  EXPECT_FALSE(significance.is_lost(gain_of(1e-4)));
  EXPECT_FALSE(significance.is_lost(gain_of(1e-5)));
}

TEST(Significance, IsNotLostIfThePredictedDecreaseIsSignificant) {
  Significance significance(0.02, 1e6, 1000);
  for (int k = 0; k < 30; ++k) {
    IterationRecord record = gain_of(1e-12);
    record.predicted_decrease = 1;
    EXPECT_FALSE(significance.is_lost(record));
  }
}

TEST(Significance, IsLostIfTenIterationsTogetherDecreaseChi2ByLessThanTheNoise) {
  EXPECT_LE(iterations_until_lost(1e-7, 0.995, 0.02, 5e4, 100), 10);
  EXPECT_GT(iterations_until_lost(1e-5, 0.995, 0.02, 5e4, 100), 100);
}

TEST(Significance, IsNotLostWhileDecreasesGrowFromASmallTrustRegion) {
  EXPECT_GT(iterations_until_lost(1e-20, 3, 0.02, 1e3, 25), 25);
}

TEST(Significance, IsNeverLostIfTheToleranceIsZero) {
  EXPECT_GT(iterations_until_lost(1e-6, 0.5, 0, 1e3, 60), 60);
}

}  // namespace
}  // namespace boxplus
