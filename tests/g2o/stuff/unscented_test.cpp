// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/stuff/unscented.h"

#include <gtest/gtest.h>

#include <vector>

namespace {

const Eigen::Matrix2d kCovariance{{2, 0.6}, {0.6, 0.5}};

TEST(Unscented, SigmaPointsHaveTheMomentsOfTheGaussian) {
  const Eigen::Vector2d mean(3, -4);
  std::vector<g2o::SigmaPoint<Eigen::Vector2d>> points;
  ASSERT_TRUE(g2o::sampleUnscented(points, mean, kCovariance));
  EXPECT_EQ(points.size(), 5u);
  Eigen::Vector2d m;
  Eigen::Matrix2d c;
  g2o::reconstructGaussian(m, c, points);
  EXPECT_LT((m - mean).norm(), 1e-8);
  EXPECT_LT((c - kCovariance).norm(), 1e-8);
  EXPECT_FALSE(g2o::sampleUnscented(points, mean, Eigen::Matrix2d(-kCovariance)));
}

}  // namespace
