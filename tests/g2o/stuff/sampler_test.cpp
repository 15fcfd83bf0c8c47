// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/stuff/sampler.h"

#include <gtest/gtest.h>

namespace {

const Eigen::Matrix2d kCovariance{{2, 0.6}, {0.6, 0.5}};

TEST(Sampler, DrawsFromTheGivenGaussian) {
  g2o::GaussianSampler<Eigen::Vector2d, Eigen::Matrix2d> sampler;
  sampler.setDistribution(kCovariance);
  sampler.seed(1);
  constexpr int kCount = 20000;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d moments = Eigen::Matrix2d::Zero();
  for (int i = 0; i < kCount; ++i) {
    const Eigen::Vector2d s = sampler.generateSample();
    mean += s / kCount;
    moments += s * s.transpose() / kCount;
  }
  EXPECT_LT(mean.norm(), 0.05);
  EXPECT_LT((moments - kCovariance).norm(), 0.1);
}

TEST(Sampler, ASeedRestartsTheSequence) {
  g2o::GaussianSampler<Eigen::VectorXd, Eigen::MatrixXd> sampler;
  sampler.setDistribution(kCovariance);
  sampler.seed(7);
  const Eigen::VectorXd first = sampler.generateSample();
  EXPECT_NE(sampler.generateSample(), first);
  sampler.seed(7);
  EXPECT_EQ(sampler.generateSample(), first);
  g2o::Sampler::seedRand(3);
  const double number = g2o::Sampler::gaussRand(1, 2);
  g2o::Sampler::seedRand(3);
  EXPECT_EQ(g2o::Sampler::gaussRand(1, 2), number);
  for (int i = 0; i < 100; ++i) {
    const double u = g2o::Sampler::uniformRand(-1, 3);
    EXPECT_TRUE(u >= -1 && u < 3);
  }
}

}  // namespace
