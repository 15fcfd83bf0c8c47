// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/inertial/direction_observation.h"

#include <gmock/gmock.h>

#include "types/inertial/inertial_graph.h"
#include "types/slam3d/sensor_world.h"

namespace boxplus {
namespace {

const S2 kUp(Vector3(0, 0, 1));

TEST(DirectionObservation, IsTheAngleBetweenTheMeasuredAndThePredictedDirection) {
  // The body is turned to its left by 90° and then rolled by 0.1, so up is at 0.1 from z towards y.
  const SE3 body = pose(7, 8, 9, 0, 0, kPi / 2) * pose(0, 0, 0, 0.1, 0, 0);
  const Vector2 e = DirectionObservation(kUp).error(body, kUp);
  EXPECT_LT((kUp.tangent_basis() * e - Vector3(0, 0.1, 0)).norm(), 1e-14);
  EXPECT_LT(DirectionObservation(kUp).error(body, kUp, SE3(Vector3(1, 2, 3), body.so3().inverse())).norm(),
            1e-14);
  EXPECT_LT((DirectionObservation(kUp).error(body.so3(), kUp) - e).norm(), 1e-14);
}

TEST(FieldObservation, IsTheFieldInTheFrameOfTheBodyPlusTheBias) {
  const SE3 body = pose(7, 8, 9, 0, 0, kPi / 2);
  const Vector3 e = FieldObservation(Vector3(1, 1, 1)).error(body, Vector3(0, 20, -40), Vector3(3, 4, 5));
  EXPECT_LT((e - Vector3(22, 3, -36)).norm(), 1e-13);
}

TEST(DirectionObservation, HasCorrectJacobiansAtRandomStates) {
  RandomNumbers random(1);
  for (int trial = 0; trial < 1000; ++trial) {
    const SE3 x = random_pose(random, 3), mount = random_pose(random, 3);
    const S2 d(random_vector(random)), z(random_vector(random));
    const SE3RotationVector y(x.translation(), x.rotation());
    expect_correct_jacobians(DirectionObservation(z), x, d);
    expect_correct_jacobians(DirectionObservation(z), x, d, mount);
    expect_correct_jacobians(DirectionObservation(z), y, d);
    expect_correct_jacobians(DirectionObservation(z), x.so3(), d, mount.so3());
    const FieldObservation field(random_vector(random));
    expect_correct_jacobians(field, x, random_vector(random), random_vector(random));
    expect_correct_jacobians(field, x.so3(), random_vector(random), random_vector(random));
  }
}

/// The odometry alone would let the attitude drift.
TEST(DirectionObservation, WithOdometryFindsAnUnknownFieldAndTheMountOfItsSensor) {
  SensorWorld world(4);
  const S2 down(Vector3(0, 0, -1)), field(Vector3(0.4, 0.1, -0.9));
  const SE3 mount = pose(0, 0, 0, 0.2, -0.3, 0.5);
  const auto known = world.graph.add_parameter(down);
  const auto unknown = world.graph.add_vertex(S2(Vector3(1, 0, -1)));
  const auto sensor = world.graph.add_vertex(SE3());
  world.graph.fix_directions(sensor, {0, 1, 2});  // a direction does not depend on the position
  constexpr double kSigma = 0.01;
  const auto measured = [&](const SE3& x, const S2& d) {
    const Vector3 seen = x.rotation().transpose() * d.vector();
    const Vector2 noise = kSigma * world.normal<2>();
    return DirectionObservation(Manifold<S2>::oplus(S2(seen), noise.data()));
  };
  for (std::size_t k = 0; k < world.poses.size(); ++k) {
    world.graph.add_edge(measured(world.truths[k], down), 1 / (kSigma * kSigma), world.poses[k], known);
    world.graph.add_edge(measured(world.truths[k] * mount, field), 1 / (kSigma * kSigma), world.poses[k],
                         unknown, sensor);
  }
  expect_chi2_of_noise(world.graph);
  expect_truth(world.graph, unknown, field);
  EXPECT_LT((world.graph.estimate(unknown).vector() - field.vector()).norm(), 0.02);
  EXPECT_LT((world.graph.estimate(sensor).so3().inverse() * mount.so3()).rotation_vector().norm(), 0.02);
}

TEST(FieldObservation, WithOdometryFindsTheFieldAndTheHardIron) {
  SensorWorld world(6);
  const Vector3 field(18, 3, -45), iron(5, -12, 9);  // µT
  const auto m = world.graph.add_vertex(Vector3(0, 0, 0)), b = world.graph.add_vertex(Vector3(0, 0, 0));
  constexpr double kSigma = 0.5;
  for (std::size_t k = 0; k < world.poses.size(); ++k) {
    const Vector3 seen = world.truths[k].rotation().transpose() * field + iron + kSigma * world.normal<3>();
    world.graph.add_edge(FieldObservation(seen), 1 / (kSigma * kSigma), world.poses[k], m, b);
  }
  expect_chi2_of_noise(world.graph);
  expect_truth(world.graph, m, field);
  expect_truth(world.graph, b, iron);
  EXPECT_LT((world.graph.estimate(b) - iron).norm(), 3);
}

}  // namespace
}  // namespace boxplus
