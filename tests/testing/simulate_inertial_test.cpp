// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/testing/simulate_inertial.h"

#include <gmock/gmock.h>

#include <cmath>

#include "boxplus/base/error.h"

namespace boxplus {
namespace {

TEST(SimulatedFlight, HasTheDerivativesOfItsPose) {
  constexpr double kStep = 1e-4;
  for (int k = 0; k < 30; ++k) {
    const double t = 3.7 * k;
    const BodyMotion motion = simulated_flight(t);
    const InertialState before = simulated_flight(t - kStep).state, after = simulated_flight(t + kStep).state;
    const Vector3 velocity = (after.pose.translation() - before.pose.translation()) / (2 * kStep);
    const Vector3 acceleration = (after.velocity - before.velocity) / (2 * kStep);
    const Vector3 turn = (before.pose.so3().inverse() * after.pose.so3()).rotation_vector() / (2 * kStep);
    EXPECT_LT((velocity - motion.state.velocity).norm(), 1e-6) << t;
    EXPECT_LT((acceleration - motion.acceleration).norm(), 1e-6) << t;
    EXPECT_LT((turn - motion.angular_velocity).norm(), 1e-6) << t;
  }
}

TEST(SimulatedFlight, LooksAheadAndSways) {
  double most = 0;
  for (int t = 0; t < 100; ++t) {
    const InertialState state = simulated_flight(t).state;
    const Vector3 ahead = state.pose.rotation().col(0), up = state.pose.rotation().col(2);
    EXPECT_GT(ahead.head<2>().dot(state.velocity.head<2>()), 0.9 * state.velocity.head<2>().norm()) << t;
    most = std::max(most, std::acos(up[2]));
  }
  EXPECT_LT(most, 0.26);
  EXPECT_GT(most, 0.2);
}

TEST(SimulateInertial, MeasuresTheMotionWithBiasAndWhiteNoise) {
  const InertialOptions options{.seconds = 50, .landmarks = 1};
  const InertialSimulation flight = simulate_inertial(options);
  ASSERT_EQ(flight.samples.size(), 10000u);
  ASSERT_EQ(flight.keyframes.size(), 101u);
  // The biases change little between keyframes, so the last ones are those of a measurement.
  double gyroscope = 0, accelerometer = 0;
  std::size_t keyframe = 0;
  for (std::size_t k = 0; k < flight.samples.size(); ++k) {
    if (flight.keyframes[keyframe + 1].next_sample == static_cast<int>(k)) ++keyframe;
    const BodyMotion motion = simulated_flight((static_cast<double>(k) + 0.5) * flight.sample_seconds);
    const ImuBias& bias = flight.keyframes[keyframe].true_bias;
    gyroscope +=
        (flight.samples[k].angular_velocity - motion.angular_velocity - bias.head<3>()).squaredNorm();
    accelerometer +=
        (flight.samples[k].specific_force - motion.specific_force(flight.gravity) - bias.tail<3>())
            .squaredNorm();
  }
  const double n = 3.0 * static_cast<double>(flight.samples.size());
  EXPECT_NEAR(std::sqrt(gyroscope / n * flight.sample_seconds), options.noise.gyroscope, 0.03 * 1.7e-4);
  EXPECT_NEAR(std::sqrt(accelerometer / n * flight.sample_seconds), options.noise.accelerometer, 0.03 * 2e-3);
}

TEST(SimulateInertial, SeesLandmarksWhereTheyAreUpToNoise) {
  const InertialSimulation flight = simulate_inertial({.seconds = 20, .pixel_noise = 0, .landmarks = 100});
  std::size_t sightings = 0;
  for (const auto& keyframe : flight.keyframes) {
    const SE3 camera = keyframe.true_state.pose * flight.camera_pose;
    for (const auto& [landmark, pixel] : keyframe.sightings) {
      const Vector3 point = camera.inverse_times(flight.true_landmarks[static_cast<std::size_t>(landmark)]);
      EXPECT_GT(point[2], 1);
      EXPECT_LT((flight.camera.project(point) - pixel).norm(), 1e-10);
    }
    sightings += keyframe.sightings.size();
  }
  EXPECT_GT(sightings, 5 * flight.keyframes.size());
}

TEST(SimulateInertial, GivesTheSameMeasurementsForTheSameSeed) {
  const InertialOptions options{.seconds = 2, .landmarks = 10, .seed = 5};
  const InertialSimulation a = simulate_inertial(options), b = simulate_inertial(options);
  EXPECT_EQ(a.samples.back().specific_force, b.samples.back().specific_force);
  EXPECT_EQ(a.keyframes.back().true_bias, b.keyframes.back().true_bias);
  InertialOptions other = options;
  other.seed = 6;
  EXPECT_NE(simulate_inertial(other).samples.back().specific_force, a.samples.back().specific_force);
}

TEST(SimulateInertial, RejectsOptionsWithoutAFlight) {
  const auto simulate_with = [](auto change) {
    InertialOptions options;
    change(options);
    return simulate_inertial(options);
  };
  EXPECT_THROW(simulate_with([](auto& o) { o.seconds = 0; }), InvalidArgument);
  EXPECT_THROW(simulate_with([](auto& o) { o.seconds = 1e12; }), InvalidArgument);
  EXPECT_THROW(simulate_with([](auto& o) { o.seconds = NAN; }), InvalidArgument);
  EXPECT_THROW(simulate_with([](auto& o) { o.imu_rate = -1; }), InvalidArgument);
  EXPECT_THROW(simulate_with([](auto& o) { o.keyframe_rate = 0; }), InvalidArgument);
  EXPECT_THROW(simulate_with([](auto& o) { o.keyframe_rate = 3; }), InvalidArgument);
  EXPECT_THROW(simulate_with([](auto& o) { o.camera_delay = INFINITY; }), InvalidArgument);
  EXPECT_THROW(simulate_with([](auto& o) { o.landmarks = 0; }), InvalidArgument);
}

}  // namespace
}  // namespace boxplus
