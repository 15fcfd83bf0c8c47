// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/robust/default_width.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "boxplus/base/error.h"

namespace boxplus {
namespace {

TEST(Chi2Quantile, EqualsPublishedTables) {
  EXPECT_NEAR(chi2_quantile(1, 0.95), 3.841458820694124, 1e-12);
  EXPECT_NEAR(chi2_quantile(2, 0.95), -2 * std::log(0.05), 1e-12);
  EXPECT_NEAR(chi2_quantile(3, 0.95), 7.814727903251178, 1e-11);
  EXPECT_NEAR(chi2_quantile(6, 0.95), 12.591587243743977, 1e-11);
  EXPECT_NEAR(chi2_quantile(100, 0.95), 124.34211340400407, 1e-10);
  EXPECT_NEAR(chi2_quantile(1, 0.5), 0.454936423119572, 1e-13);
  EXPECT_NEAR(chi2_quantile(2, 1e-6), 2e-6, 2e-12);
  EXPECT_NEAR(chi2_quantile(2, 1 - 1e-9), -2 * std::log(1e-9), 1e-5);
}

TEST(Chi2Quantile, ApproachesTheQuantileOfTheNormalDistributionForManyRows) {
  const double z = 1.6448536269514722;
  for (const int rows : {1'000, 1'000'000, std::numeric_limits<int>::max()}) {
    const double n = rows;
    // The first terms of the Cornish-Fisher expansion. The remainder decreases like 1 / √n.
    const double expected = n + z * std::sqrt(2 * n) + 2.0 / 3 * (z * z - 1);
    EXPECT_NEAR(chi2_quantile(rows, 0.95), expected, 1 / std::sqrt(n) + 1e-9 * std::sqrt(n)) << rows;
  }
}

TEST(Chi2Quantile, IsAboveTheRequestedFractionOfRandomErrors) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (const int rows : {1, 2, 3, 6, 40, 41, 80}) {
    int within = 0;
    for (int i = 0; i < 20000; ++i) {
      double chi2 = 0;
      for (int k = 0; k < rows; ++k) {
        const double e = normal(random);
        chi2 += e * e;
      }
      within += chi2 < chi2_quantile(rows, 0.95);
    }
    EXPECT_NEAR(within / 20000.0, 0.95, 0.006) << rows;  // four standard deviations
  }
}

TEST(Chi2Quantile, GrowsWithTheProbabilityAndTheRows) {
  double last = 0;
  for (int rows = 1; rows <= 60; ++rows) {
    EXPECT_GT(default_width(rows), last) << rows;
    last = default_width(rows);
    EXPECT_LT(chi2_quantile(rows, 0.5), chi2_quantile(rows, 0.9));
  }
}

TEST(Chi2Quantile, RefusesInvalidRowsAndProbabilities) {
  EXPECT_THROW((void)chi2_quantile(0, 0.95), InvalidArgument);
  EXPECT_THROW((void)default_width(-3), InvalidArgument);
  for (const double p : {0.0, 1.0, -0.5, 2.0, std::nan("")})
    EXPECT_THROW((void)chi2_quantile(3, p), InvalidArgument);
}

}  // namespace
}  // namespace boxplus
