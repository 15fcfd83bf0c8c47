// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "g2o/core/block_solver.h"
#include "g2o/core/optimization_algorithm_levenberg.h"
#include "g2o/edge_checks.h"
#include "g2o/solvers/eigen/linear_solver_eigen.h"
#include "g2o/types/sclam2d/closed_form_calibration.h"
#include "g2o/types/sclam2d/types_sclam2d.h"

G2O_USE_TYPE_GROUP(sclam);

namespace {

using edge_checks::omega;

TEST(Sclam2d, AllTypesHaveExactJacobiansAndAreWrittenAsTheyWereRead) {
  edge_checks::expect_laws_of_file(
      "VERTEX_SE2 0 1 2 0.5\n"
      "VERTEX_SE2 1 1.8 2.5 0.9\n"
      "VERTEX_SE2 2 0.2 -0.1 0.3\n"
      "VERTEX_ODOM_DIFFERENTIAL 3 0.9 1.1 0.5\n"
      "EDGE_SE2_CALIB 0 1 2 0.9 -0.2 0.3" +
      omega(3) +
      "\n"
      "EDGE_SE2_ODOM_DIFFERENTIAL_CALIB 0 1 3 0.8 1.1 1.2" +
      omega(3) + "\n");
}

TEST(Sclam2d, ErrorsFollowTheSignConventionsOfTheFileFormat) {
  // The corrected speeds are 3 and 5, so the robot drives a quarter of a circle with radius 4. The sensor
  // moves by (0, 1) and turns by 90°.
  edge_checks::expect_errors(
      "VERTEX_SE2 0 0 0 0\n"
      "VERTEX_SE2 1 4 5 1.5707963267948966\n"
      "VERTEX_SE2 2 1 0 1.5707963267948966\n"
      "VERTEX_SE2 3 1 0 0\n"
      "VERTEX_ODOM_DIFFERENTIAL 4 0.5 2 2\n"
      "EDGE_SE2_ODOM_DIFFERENTIAL_CALIB 0 1 4 6 2.5 1.5707963267948966" +
          omega(3) +
          "\n"
          "EDGE_SE2_CALIB 0 2 3 0 0.5 1.5707963267948966" +
          omega(3) + "\n",
      {{"EDGE_SE2_ODOM_DIFFERENTIAL_CALIB", {1, 0, 0}}, {"EDGE_SE2_CALIB", {0.5, 0, 0}}});
}

TEST(Sclam2d, TheOriginOfTheOdometryHasNoCorrection) {
  g2o::VertexOdomDifferentialParams v;
  v.setEstimate(g2o::Vector3(2, 3, 4));
  v.setToOrigin();
  EXPECT_EQ(v.estimate(), g2o::Vector3(1, 1, 1));
}

TEST(OdomConvert, ConvertsSpeedsToMotionsAlongArcs) {
  const auto straight = g2o::OdomConvert::convertToMotion(g2o::VelocityMeasurement(2, 2, 0.5));
  EXPECT_EQ(straight.measurement(), g2o::Vector3(1, 0, 0));
  EXPECT_EQ(straight.dt(), 0.5);
  const auto quarter = g2o::OdomConvert::convertToMotion(g2o::VelocityMeasurement(3, 5, M_PI / 2), 2);
  EXPECT_LT((quarter.measurement() - g2o::Vector3(4, 4, M_PI / 2)).norm(), 1e-14);
  // More than half a turn is not wrapped.
  EXPECT_EQ(g2o::OdomConvert::convertToMotion(g2o::VelocityMeasurement(-2, 2, 1)).theta(), 4);
}

TEST(OdomConvert, ConvertsMotionsBackToSpeeds) {
  using Speeds = g2o::VelocityMeasurement;
  for (const Speeds& v :
       {Speeds(1, 1, 0.5), Speeds(1, 1.2, 2), Speeds(-0.5, 0.5, 1), Speeds(-1, -0.8, 0.3)}) {
    const Speeds back = g2o::OdomConvert::convertToVelocity(g2o::OdomConvert::convertToMotion(v));
    EXPECT_LT((back.measurement() - v.measurement()).norm(), 1e-14);
    EXPECT_EQ(back.dt(), v.dt());
  }
}

TEST(OdomConvert, ReportsADurationThatIsNotPositive) {
  std::string message;
  g2o::logging::setSink([&](g2o::logging::Level, const std::string& text) { message = text; });
  const auto v = g2o::OdomConvert::convertToVelocity(g2o::MotionMeasurement(1, 0, 0, 0));
  g2o::logging::setSink({});
  EXPECT_EQ(v.measurement(), g2o::Vector2(0, 0));
  EXPECT_EQ(message, "convertToVelocity(): expected dt > 0, got 0");
}

const g2o::Vector3 kOdometry(1.05, 0.97, 0.42);
const g2o::SE2 kLaser(0.3, -0.1, 0.4);
const g2o::Vector3 kDriveNoise(0.01, 0.01, 0.005), kLaserNoise(0.003, 0.003, 0.002);

struct Drive {
  std::vector<g2o::VelocityMeasurement> wheels;
  g2o::MotionInformationVector motions;
};

/// A robot that drives at random speeds. Its motions have `noise` times the noise above.
Drive drive(int motions, double noise, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> speed(-0.2, 1.0);
  std::normal_distribution<double> gauss;
  const auto error = [&](const g2o::Vector3& sigma) {
    g2o::Vector3 e;
    for (int i = 0; i < 3; ++i) e[i] = noise * sigma[i] * gauss(random);
    return g2o::SE2(e);
  };
  Drive result;
  for (int i = 0; i < motions; ++i) {
    const double left = speed(random), right = speed(random);
    const g2o::VelocityMeasurement wheels(left, right, 0.5),
        corrected(kOdometry[0] * left, kOdometry[1] * right, 0.5);
    const g2o::SE2 motion =
        g2o::SE2(g2o::OdomConvert::convertToMotion(corrected, kOdometry[2]).measurement()) *
        error(kDriveNoise);
    g2o::MotionInformation m;
    m.laserMotion = kLaser.inverse() * motion * kLaser * error(kLaserNoise).inverse();
    m.odomMotion = g2o::SE2(g2o::OdomConvert::convertToMotion(wheels).measurement());
    m.timeInterval = 0.5;
    result.wheels.push_back(wheels);
    result.motions.push_back(m);
  }
  return result;
}

TEST(ClosedFormCalibration, IsExactForExactMotions) {
  g2o::SE2 laser;
  g2o::Vector3 odometry;
  ASSERT_TRUE(g2o::ClosedFormCalibration::calibrate(drive(10, 0, 1).motions, laser, odometry));
  EXPECT_LT((laser.toVector() - kLaser.toVector()).norm(), 1e-11);
  EXPECT_LT((odometry - kOdometry).norm(), 1e-11);
}

TEST(ClosedFormCalibration, RefusesMotionsThatDoNotDetermineAllParameters) {
  g2o::SE2 laser(1, 2, 0.5);
  g2o::Vector3 odometry(1, 2, 3);
  g2o::MotionInformationVector straight(5);
  for (g2o::MotionInformation& m : straight) m.laserMotion = m.odomMotion = g2o::SE2(1, 0, 0);
  EXPECT_FALSE(g2o::ClosedFormCalibration::calibrate(straight, laser, odometry));
  g2o::MotionInformationVector bad = drive(10, 0, 1).motions;
  g2o::logging::setSink({});
  bad[3].timeInterval = 0;
  EXPECT_FALSE(g2o::ClosedFormCalibration::calibrate(bad, laser, odometry));
  bad[3].timeInterval = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(g2o::ClosedFormCalibration::calibrate(bad, laser, odometry));
  EXPECT_EQ(laser.toVector(), g2o::Vector3(1, 2, 0.5));
  EXPECT_EQ(odometry, g2o::Vector3(1, 2, 3));
}

g2o::Matrix3 information(const g2o::Vector3& sigma) {
  return sigma.cwiseAbs2().cwiseInverse().asDiagonal();
}

TEST(ClosedFormCalibration, StartsAnOptimizationThatEndsAtTheTruth) {
  constexpr int kMotions = 400;
  const Drive driven = drive(kMotions, 1, 1);
  g2o::SE2 laser;
  g2o::Vector3 odometry;
  ASSERT_TRUE(g2o::ClosedFormCalibration::calibrate(driven.motions, laser, odometry));
  EXPECT_LT((laser.toVector() - kLaser.toVector()).norm(), 0.03);
  EXPECT_LT((odometry - kOdometry).norm(), 0.03);

  g2o::SparseOptimizer optimizer;
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmLevenberg(
      new g2o::BlockSolverX(new g2o::LinearSolverEigen<g2o::BlockSolverX::PoseMatrixType>())));
  auto* laser_vertex = new g2o::VertexSE2;
  laser_vertex->setId(kMotions + 1);
  laser_vertex->setEstimate(laser);
  optimizer.addVertex(laser_vertex);
  auto* odometry_vertex = new g2o::VertexOdomDifferentialParams;
  odometry_vertex->setId(kMotions + 2);
  odometry_vertex->setEstimate(odometry);
  optimizer.addVertex(odometry_vertex);
  auto* last = new g2o::VertexSE2;
  last->setId(0);
  last->setFixed(true);
  optimizer.addVertex(last);
  for (int i = 0; i < kMotions; ++i) {
    auto* next = new g2o::VertexSE2;
    next->setId(i + 1);
    optimizer.addVertex(next);
    auto* wheels = new g2o::EdgeSE2OdomDifferentialCalib;
    wheels->setVertex(0, last);
    wheels->setVertex(1, next);
    wheels->setVertex(2, odometry_vertex);
    wheels->setMeasurement(driven.wheels[static_cast<size_t>(i)]);
    wheels->setInformation(information(kDriveNoise));
    ASSERT_TRUE(optimizer.addEdge(wheels));
    wheels->initialEstimate({last, odometry_vertex}, next);
    auto* scan = new g2o::EdgeSE2SensorCalib;
    scan->setVertex(0, last);
    scan->setVertex(1, next);
    scan->setVertex(2, laser_vertex);
    scan->setMeasurement(driven.motions[static_cast<size_t>(i)].laserMotion);
    scan->setInformation(information(kLaserNoise));
    ASSERT_TRUE(optimizer.addEdge(scan));
    last = next;
  }
  ASSERT_TRUE(optimizer.initializeOptimization());
  EXPECT_GT(optimizer.optimize(20), 0);
  const double degrees_of_freedom = 3 * kMotions - 6;
  EXPECT_NEAR(optimizer.activeChi2(), degrees_of_freedom, 5 * std::sqrt(2 * degrees_of_freedom));
  EXPECT_LT((laser_vertex->estimate().toVector() - kLaser.toVector()).norm(), 0.005);
  EXPECT_LT((odometry_vertex->estimate() - kOdometry).norm(), 0.005);
}

}  // namespace
