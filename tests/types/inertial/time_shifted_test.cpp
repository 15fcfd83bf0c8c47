// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/inertial/time_shifted.h"

#include <gmock/gmock.h>

#include "boxplus/types/between.h"
#include "types/inertial/inertial_graph.h"
#include "types/slam3d/sensor_world.h"

namespace boxplus {
namespace {

TEST(TimeShifted, MovesThePoseByItsVelocities) {
  const SE3 body = pose(1, 2, 3, 0, 0, 0);
  const TimeShifted edge(Prior(SE3{}), Vector3(0, 0, kPi / 2));
  const SE3 later = pose(3, 2, 3, 0, 0, kPi / 4);
  EXPECT_LT((edge.error(body, Vector3(4, 0, 0), 0.5) - later.minimal()).norm(), 1e-14);
  EXPECT_LT((edge.error(body, Vector3(4, 0, 0), 0.0) - body.minimal()).norm(), 1e-14);
}

TEST(TimeShifted, HasCorrectJacobiansAtRandomStates) {
  RandomNumbers random(1);
  for (int trial = 0; trial < 300; ++trial) {
    const SE3 x = random_pose(random, 2), y = random_pose(random, 2), mount = random_pose(random, 1);
    const Vector3 v = random_vector(random), w = random_vector(random), omega = random_vector(random),
                  omega_j = random_vector(random), point = random_vector(random);
    const double offset = random.uniform(-0.3, 0.3);
    expect_correct_jacobians(TimeShifted(Between(mount), omega, omega_j), x, v, y, w, offset);
    expect_correct_jacobians(TimeShifted(OffsetPositionPrior(point), omega), x, v, offset, w);
    expect_correct_jacobians(TimeShifted(OffsetPointObservation3(point), omega), x, v, offset, w, mount);
    const SE3RotationVector z(x.translation(), x.rotation());
    expect_correct_jacobians(TimeShifted(Prior(z), omega), z, v, offset);
  }
}

/// The angular velocity at a keyframe that a gyroscope measures.
Vector3 measured_turn(const InertialSimulation& simulation, std::size_t k) {
  const auto next = static_cast<std::size_t>(simulation.keyframes[k].next_sample);
  const auto last = simulation.samples.size() - 1;
  const Vector3 mean = 0.5 * (simulation.samples[std::min(next, last)].angular_velocity +
                              simulation.samples[next == 0 ? 0 : next - 1].angular_velocity);
  return mean - simulation.keyframes[k].true_bias.head<3>();
}

TEST(TimeShifted, FindsTheDelayOfACamera) {
  constexpr double kDelay = 0.015;
  InertialGraph flight({.seconds = 10, .camera_delay = kDelay, .landmarks = 80, .seed = 5});
  flight.add_motions();
  const auto offset = flight.graph.add_vertex(0.0);
  flight.add_landmarks([&](std::size_t k, const Reprojection<PinholeCamera>& edge, const auto&... more) {
    flight.graph.add_edge(TimeShifted(edge, measured_turn(flight.simulation, k)), 1.0, flight.poses[k],
                          flight.velocities[k], offset, more...);
  });
  expect_chi2_of_noise(flight.graph);
  expect_truth(flight.graph, offset, kDelay);
  EXPECT_NEAR(flight.graph.estimate(offset), kDelay, 0.001);
}

TEST(TimeShifted, FindsTheDelayOfSatellitePositions) {
  constexpr double kDelay = -0.05, kSigma = 0.02;
  InertialGraph flight({.seconds = 60, .imu_rate = 100, .keyframe_rate = 1, .seed = 8});
  flight.graph.unfix(flight.poses[0]);
  flight.add_motions();
  const auto offset = flight.graph.add_vertex(0.0);
  const Vector3 truth(0.4, -0.3, 0.9);
  const auto arm = flight.graph.add_vertex(Vector3(0, 0, 0));
  RandomNumbers random(3);
  for (std::size_t k = 0; k < flight.poses.size(); ++k) {
    const SE3 body = simulated_flight(flight.simulation.keyframes[k].time + kDelay).state.pose;
    const OffsetPositionPrior position(Vector3(body * truth + kSigma * random_vector(random)));
    flight.graph.add_edge(TimeShifted(position, measured_turn(flight.simulation, k)), 1 / (kSigma * kSigma),
                          flight.poses[k], flight.velocities[k], offset, arm);
  }
  expect_chi2_of_noise(flight.graph);
  expect_truth(flight.graph, offset, kDelay);
  EXPECT_NEAR(flight.graph.estimate(offset), kDelay, 0.01);
  expect_truth(flight.graph, arm, truth);
}

/// Odometry by another sensor, for example by a laser, whose clock differs from that of the IMU.
TEST(TimeShifted, FindsTheDelayOfOdometry) {
  constexpr double kDelay = 0.02, kTranslation = 0.003, kRotation = 0.001;
  InertialGraph flight({.seconds = 60, .imu_rate = 100, .keyframe_rate = 2, .seed = 9});
  flight.add_motions();
  const auto offset = flight.graph.add_vertex(0.0);
  RandomNumbers random(4);
  const auto& keyframes = flight.simulation.keyframes;
  for (std::size_t k = 1; k < flight.poses.size(); ++k) {
    Vector<double, 6> step;
    step << kTranslation * random_vector(random), kRotation / 2 * random_vector(random);
    const SE3 from = simulated_flight(keyframes[k - 1].time + kDelay).state.pose,
              to = simulated_flight(keyframes[k].time + kDelay).state.pose;
    const Between z(from.inverse() * to * Manifold<SE3>::oplus(SE3(), step.data()));
    const TimeShifted edge(z, measured_turn(flight.simulation, k - 1), measured_turn(flight.simulation, k));
    flight.graph.add_edge(edge, Information::se3_sigmas(kTranslation, kRotation), flight.poses[k - 1],
                          flight.velocities[k - 1], flight.poses[k], flight.velocities[k], offset);
  }
  expect_chi2_of_noise(flight.graph);
  expect_truth(flight.graph, offset, kDelay);
  EXPECT_NEAR(flight.graph.estimate(offset), kDelay, 0.005);
}

}  // namespace
}  // namespace boxplus
