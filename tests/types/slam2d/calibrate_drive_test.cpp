// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/slam2d/calibrate_drive.h"

#include <gmock/gmock.h>

#include <Eigen/Cholesky>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "boxplus/base/error.h"
#include "boxplus/covariance/covariance.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/types/slam2d.h"

namespace boxplus {
namespace {

const DifferentialDrive kDrive{1.05, 0.97, 0.42};
const SE2 kMount(0.3, -0.1, 0.4);

/// Standard deviations of (x, y, θ) of the driven motion and of the motion of the sensor.
constexpr std::array<double, 3> kDriveNoise{0.01, 0.01, 0.005}, kSensorNoise{0.003, 0.003, 0.002};

/// A robot that drives at random speeds. Its motions deviate from the motion of its wheels by `noise` times
/// kDriveNoise, and its sensor measures them with `noise` times kSensorNoise.
std::vector<DriveMotion> drive(int motions, double noise, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> speed(-0.2, 1.0);
  std::normal_distribution<double> gauss;
  const auto error = [&](const std::array<double, 3>& sigma) {
    const double x = gauss(random), y = gauss(random), theta = gauss(random);
    return SE2(noise * sigma[0] * x, noise * sigma[1] * y, noise * sigma[2] * theta);
  };
  std::vector<DriveMotion> result;
  for (int i = 0; i < motions; ++i) {
    const double left = speed(random), right = speed(random);
    const WheelSpeeds wheels{left, right, 0.5};
    const SE2 motion = WheelOdometry(wheels).motion(kDrive) * error(kDriveNoise);
    result.push_back({wheels, kMount.inverse() * motion * kMount * error(kSensorNoise).inverse()});
  }
  return result;
}

void expect_truth(const DriveCalibration& found, double tolerance) {
  EXPECT_NEAR(found.drive.left_factor, kDrive.left_factor, tolerance);
  EXPECT_NEAR(found.drive.right_factor, kDrive.right_factor, tolerance);
  EXPECT_NEAR(found.drive.baseline, kDrive.baseline, tolerance);
  EXPECT_LT((found.mount.vector() - kMount.vector()).norm(), tolerance);
}

TEST(CalibrateDrive, IsExactForExactMotions) {
  const auto found = calibrate_drive(drive(10, 0, 1));
  ASSERT_TRUE(found);
  expect_truth(*found, 1e-11);
}

TEST(CalibrateDrive, NeedsOnlyAStraightLineAndACircle) {
  std::vector<DriveMotion> motions;
  for (const WheelSpeeds& wheels : {WheelSpeeds{kDrive.right_factor, kDrive.left_factor, 1}, {1, 1.5, 1}})
    motions.push_back({wheels, kMount.inverse() * WheelOdometry(wheels).motion(kDrive) * kMount});
  EXPECT_NEAR(motions[0].sensor.theta(), 0, 1e-15);
  const auto found = calibrate_drive(motions);
  ASSERT_TRUE(found);
  expect_truth(*found, 1e-12);
}

TEST(CalibrateDrive, FindsASensorThatLooksBackwards) {
  const SE2 mount(-0.2, 0.05, 3.1);
  std::vector<DriveMotion> motions;
  for (const WheelSpeeds& wheels : {WheelSpeeds{-1, -1, 1}, {-1, 1, 0.4}, {0.5, 1, 2}})
    motions.push_back({wheels, mount.inverse() * WheelOdometry(wheels).motion(kDrive) * mount});
  const auto found = calibrate_drive(motions);
  ASSERT_TRUE(found);
  EXPECT_LT((found->mount.vector() - mount.vector()).norm(), 1e-12);
  EXPECT_NEAR(found->drive.baseline, kDrive.baseline, 1e-12);
}

TEST(CalibrateDrive, RefusesMotionsThatDoNotDetermineAllParameters) {
  EXPECT_FALSE(calibrate_drive({}));
  for (const double right : {1.0, 1.5, -1.0}) {  // straight on, on a circle, on the spot
    std::vector<DriveMotion> motions;
    for (const double speed : {0.2, 0.5, 0.7}) {
      const WheelSpeeds wheels{speed, speed * right, 1};
      motions.push_back({wheels, kMount.inverse() * WheelOdometry(wheels).motion(kDrive) * kMount});
    }
    EXPECT_FALSE(calibrate_drive(motions)) << right;
  }
  std::vector<DriveMotion> at_rest = drive(10, 0, 1);
  for (DriveMotion& motion : at_rest) motion.sensor = SE2();
  EXPECT_FALSE(calibrate_drive(at_rest));
}

TEST(CalibrateDrive, NamesTheMotionThatIsNotFinite) {
  std::vector<DriveMotion> motions = drive(3, 0, 1);
  motions[2].wheels.left = std::numeric_limits<double>::quiet_NaN();
  try {
    static_cast<void>(calibrate_drive(motions));
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("motion 2"));
  }
}

TEST(WheelSpeedsOfAMotion, AreTheInverseOfTheDrivenArc) {
  for (const WheelSpeeds& wheels :
       {WheelSpeeds{1, 1, 0.5}, {1, 1.5, 2}, {-1, 1, 0.4}, {-0.5, -0.7, 1}, {1, 1 + 1e-9, 1}, {0, 0, 1}}) {
    const WheelSpeeds back = wheel_speeds(WheelOdometry(wheels).motion(kDrive), wheels.duration, kDrive);
    EXPECT_NEAR(back.left, wheels.left, 1e-14);
    EXPECT_NEAR(back.right, wheels.right, 1e-14);
    EXPECT_EQ(back.duration, wheels.duration);
  }
  EXPECT_THROW(static_cast<void>(wheel_speeds(SE2(), 0)), InvalidArgument);
}

TEST(WheelSpeedsOfAMotion, LeaveOutTheMotionAcrossTheArc) {
  const WheelSpeeds ahead = wheel_speeds(SE2(1, 0.3, 0), 2);
  EXPECT_EQ(ahead.left, 0.5);
  EXPECT_EQ(ahead.right, 0.5);
}

/// The graph of the motions, which starts at the closed-form calibration.
struct CalibrationGraph {
  explicit CalibrationGraph(const std::vector<DriveMotion>& motions, const DriveCalibration& start) {
    const auto omega = [](const std::array<double, 3>& sigma) {
      std::array<double, 3> weights;
      for (std::size_t i = 0; i < 3; ++i) weights[i] = 1 / (sigma[i] * sigma[i]);
      return Information::diagonal(weights);
    };
    drive = graph.add_vertex(start.drive);
    mount = graph.add_vertex(start.mount);
    auto last = graph.add_vertex(SE2());
    graph.fix(last);
    for (const auto& [wheels, sensor] : motions) {
      const WheelOdometry odometry(wheels);
      const auto next = graph.add_vertex(graph.estimate(last) * odometry.motion(start.drive));
      graph.add_edge(odometry, omega(kDriveNoise), last, next, drive);
      graph.add_edge(OffsetBetween<SE2>(sensor), omega(kSensorNoise), last, next, mount);
      last = next;
    }
  }

  Graph graph;
  VertexHandle<DifferentialDrive> drive;
  VertexHandle<SE2> mount;
};

TEST(CalibrateDrive, StartsNearTheTruthAndTheGraphEndsAtItWithTheChi2OfTheNoise) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    const auto motions = drive(400, 1, seed);
    const auto start = calibrate_drive(motions);
    ASSERT_TRUE(start);
    expect_truth(*start, 0.03);
    CalibrationGraph problem(motions, *start);
    const Report report = optimize(problem.graph, {.start = Start::kCurrent});
    ASSERT_TRUE(report.converged()) << report;
    ASSERT_EQ(report.degrees_of_freedom, 3 * 400 - 6);
    EXPECT_NEAR(report.chi2_per_degree(), 1, 5 * std::sqrt(2.0 / (3 * 400 - 6))) << report;

    // The errors of both calibrations are those that their covariances predict.
    const Covariance covariance = boxplus::covariance(problem.graph, {problem.drive, problem.mount});
    ASSERT_TRUE(covariance.ok()) << covariance.message();
    Vector3 drive_error, mount_error;
    Manifold<DifferentialDrive>::ominus(problem.graph.estimate(problem.drive), kDrive, drive_error.data());
    Manifold<SE2>::ominus(problem.graph.estimate(problem.mount), kMount, mount_error.data());
    EXPECT_LT(drive_error.dot(covariance.of(problem.drive).ldlt().solve(drive_error)), 20);
    EXPECT_LT(mount_error.dot(covariance.of(problem.mount).ldlt().solve(mount_error)), 20);
  }
}

}  // namespace
}  // namespace boxplus
