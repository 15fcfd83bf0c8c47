// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cstdlib>
#include <thread>

#include "g2o/stuff/sampler.h"
#include "g2o/stuff/tictoc.h"
#include "g2o/stuff/timeutil.h"
#include "g2o/stuff/unscented.h"

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

TEST(Time, ACommandRepeatsByTheClockOfTheCaller) {
  int runs = 0;
  for (double now : {10.0, 10.5, 11.0, 11.5, 3.0, 3.5}) DO_EVERY_TS(1, now, ++runs);
  EXPECT_EQ(runs, 3);  // at 10, at 11, and when the clock was set back
}

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

TEST(TicToc, MeasuresNamedPartsIfTheVariableIsSet) {
  setenv("G2O_ENABLE_TICTOC", "1", 1);
  EXPECT_EQ(g2o::tictoc("sleep"), -1);
  std::this_thread::sleep_for(std::chrono::milliseconds(2));
  EXPECT_GE(g2o::tictoc("sleep"), 0.002);
  { const g2o::ScopeTicToc scope("scope"); }
  EXPECT_THAT(g2o::tictocReport(),
              testing::AllOf(testing::HasSubstr("sleep\tnumber= 1"), testing::HasSubstr("scope\tnumber= 1")));
}

void a_measured_function() {
  MEASURE_FUNCTION_TIME;
}

TEST(TimeUtil, PrintsTheTimeOfAFunction) {
  testing::internal::CaptureStderr();
  { const g2o::ScopeTime time("scope"); }
  MEASURE_TIME("code", EXPECT_TRUE(true));
  a_measured_function();
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              testing::AllOf(testing::StartsWith("scope "), testing::HasSubstr(" ms\ncode "),
                             testing::HasSubstr("a_measured_function")));
}

TEST(TimeUtil, RepeatsACommandAfterItsInterval) {
  int often = 0, seldom = 0;
  for (int k = 0; k < 3; ++k) {
    DO_EVERY(0, ++often);
    DO_EVERY(3600, ++seldom);
  }
  EXPECT_EQ(often, 3);
  EXPECT_EQ(seldom, 1);
}

TEST(TimeUtil, FormatsATime) {
  std::tm noon{};
  noon.tm_year = 112;
  noon.tm_mon = 0;
  noon.tm_mday = 31;
  noon.tm_hour = 12;
  EXPECT_EQ(g2o::getTimeAsString(std::mktime(&noon)), "20120131_120000");
  EXPECT_EQ(g2o::getCurrentTimeAsString().size(), 15u);
}

}  // namespace
