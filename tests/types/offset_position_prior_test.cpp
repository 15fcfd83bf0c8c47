// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/offset_position_prior.h"

#include <gmock/gmock.h>

#include "boxplus/manifold/se2.h"
#include "types/inertial/inertial_graph.h"
#include "types/slam3d/sensor_world.h"

namespace boxplus {
namespace {

TEST(OffsetPositionPrior, MeasuresThePositionOfTheAntenna) {
  const SE3 body = pose(1, 2, 3, 0, 0, kPi / 2);
  const Vector3 e = OffsetPositionPrior(Vector3(0, 0, 0)).error(body, Vector3(0.5, 0, 1));
  EXPECT_LT((e - Vector3(1, 2.5, 4)).norm(), 1e-14);
  const Vector2 planar = OffsetPositionPrior(Vector2(1, 1)).error(SE2(1, 2, kPi), Vector2(0.5, 0));
  EXPECT_LT((planar - Vector2(-0.5, 1)).norm(), 1e-14);
}

TEST(OffsetPositionPrior, HasCorrectJacobiansAtRandomStates) {
  RandomNumbers random(1);
  for (int trial = 0; trial < 1000; ++trial) {
    const Vector3 z = random_vector(random), arm = random_vector(random);
    const SE3 x = random_pose(random, 3);
    expect_correct_jacobians(OffsetPositionPrior(z), x, arm);
    expect_correct_jacobians(OffsetPositionPrior(z), SE3RotationVector(x.translation(), x.rotation()), arm);
    expect_correct_jacobians(OffsetPositionPrior(Vector2(z[0], z[1])), SE2(arm[0], arm[1], arm[2]),
                             Vector2(arm[2], z[2]));
  }
}

TEST(OffsetPositionPrior, PredictsThePositionOfTheBody) {
  SE3 body = pose(1, 2, 3, 0.1, 0.2, 0.3);
  const OffsetPositionPrior<Vector3> edge(Vector3(4, 5, 6));
  const Vector3 arm(0.5, 0.6, 0.7);
  detail::Frame frame = detail::FrameTrait<SE3>::get(body);
  frame.translation = edge.relative_frame(body, arm).motion.translation;
  detail::FrameTrait<SE3>::set(body, frame);
  EXPECT_LT(edge.error(body, arm).norm(), 1e-14);
}

/// Satellite positions of 2 cm and an IMU determine everything: poses, velocities, biases and the lever arm.
TEST(OffsetPositionPrior, WithAnImuFindsTheLeverArm) {
  InertialGraph flight({.seconds = 60, .imu_rate = 100, .keyframe_rate = 1, .seed = 2});
  flight.graph.unfix(flight.poses[0]);
  flight.add_motions();
  const Vector3 truth(0.4, -0.3, 0.9);
  const auto arm = flight.graph.add_vertex(Vector3(0, 0, 0));
  RandomNumbers random(3);
  constexpr double kSigma = 0.02;
  for (std::size_t k = 0; k < flight.poses.size(); ++k) {
    const SE3& body = flight.simulation.keyframes[k].true_state.pose;
    flight.graph.add_edge(OffsetPositionPrior(Vector3(body * truth + kSigma * random_vector(random))),
                          1 / (kSigma * kSigma), flight.poses[k], arm);
  }
  expect_chi2_of_noise(flight.graph);
  expect_truth(flight.graph, arm, truth);
  EXPECT_LT((flight.graph.estimate(arm) - truth).norm(), 0.1);
  expect_truth(flight.graph, flight.poses.back(), flight.simulation.keyframes.back().true_state.pose);
  expect_truth(flight.graph, flight.biases.back(), flight.simulation.keyframes.back().true_bias);
}

}  // namespace
}  // namespace boxplus
