// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/inertial/inertial_between.h"

#include <gmock/gmock.h>

#include <cmath>

#include "types/expect_jacobians.h"
#include "types/inertial/inertial_graph.h"
#include "types/slam3d/sensor_world.h"

namespace boxplus {
namespace {

ImuBias random_bias(RandomNumbers& random, double size) {
  ImuBias bias;
  for (double& value : bias) value = size * random.normal();
  return bias;
}

InertialMotion random_motion(RandomNumbers& random) {
  Preintegration sum(ImuNoise{}, random_bias(random, 0.05));
  const Vector3 turn = random_vector(random);
  for (int k = 0; k < 10; ++k)
    sum.integrate(turn + 0.3 * random_vector(random), 4 * random_vector(random), 0.05);
  return sum.motion();
}

TEST(InertialBetween, ComparesTheStatesWithTheMeasuredMotion) {
  InertialMotion motion;
  motion.seconds = 2;
  motion.rotation = SO3::from_rotation_vector(Vector3(0, 0, 0.1)).quaternion();
  motion.velocity = {1, 2, 3};
  motion.position = {4, 5, 6};
  motion.bias << 0.1, 0, 0, 0, 0, 0;
  motion.bias_jacobian(0, 0) = motion.bias_jacobian(3, 3) = motion.bias_jacobian(6, 0) = 1;
  const SE3 turned = pose(0, 0, 0, 0, 0, kPi / 2), end = pose(1, 0, 0, 0, 0, kPi / 2 + 0.4);
  ImuBias bias_i = motion.bias, bias_j = motion.bias;
  bias_j[5] = 7;
  // In the frame at i, x and y of the world are −y and x. v_j − v_i − g Δt = (0, 1, 20),
  // p_j − p_i − v_i Δt − ½ g Δt² = (1, 0, 20).
  const InertialBetween edge(motion, Vector3(0, 0, -10));
  Vector<double, 15> expected;
  expected << 0, 0, 0.3, 0, -2, 17, -4, -6, 14, 0, 0, 0, 0, 0, 7;
  const auto error = [&] {
    return edge.error(turned, Vector3(0, 0, 0), bias_i, end, Vector3(0, 1, 0), bias_j);
  };
  EXPECT_LT((error() - expected).norm(), 1e-14);
  // The measured velocity and position change with the biases at i.
  bias_i[0] += 1e-9;
  bias_i[3] += 0.5;
  bias_j = bias_i;
  expected << -1e-9, 0, 0.3, -0.5, -2, 17, -4, -6, 14, 0, 0, 0, 0, 0, 0;
  EXPECT_LT((error() - expected).norm(), 1e-8);
}

TEST(InertialBetween, IsZeroAtThePredictedState) {
  RandomNumbers random(2);
  for (int trial = 0; trial < 20; ++trial) {
    const InertialMotion motion = random_motion(random);
    const SE3 begin = random_pose(random, 2);
    const Vector3 velocity = random_vector(random), gravity = random_vector(random);
    const ImuBias bias = motion.bias + random_bias(random, 0.1);
    const InertialState end = motion.predict(begin, velocity, bias, gravity);
    const auto e =
        InertialBetween(motion, gravity).error(begin, velocity, bias, end.pose, end.velocity, bias);
    EXPECT_LT(e.norm(), 1e-13);
  }
}

TEST(InertialBetween, HasCorrectJacobiansAtRandomStates) {
  RandomNumbers random(1);
  for (int trial = 0; trial < 1000; ++trial) {
    const InertialMotion motion = random_motion(random);
    const Vector3 v_i = random_vector(random), v_j = random_vector(random);
    const ImuBias b_i = motion.bias + random_bias(random, 0.1), b_j = random_bias(random, 0.1);
    const SE3 x_i = random_pose(random, 3), x_j = random_pose(random, 3);
    const InertialBetween edge(motion, 9.8 * random_vector(random).normalized());
    expect_correct_jacobians(edge, x_i, v_i, b_i, x_j, v_j, b_j);
    expect_correct_jacobians(edge, x_i, v_i, b_i, x_j, v_j, b_j, S2(random_vector(random)));
    const SE3RotationVector y_i(x_i.translation(), x_i.rotation()), y_j(x_j.translation(), x_j.rotation());
    expect_correct_jacobians(edge, y_i, v_i, b_i, y_j, v_j, b_j);
    expect_correct_jacobians(edge, y_i, v_i, b_i, y_j, v_j, b_j, S2(random_vector(random)));
  }
}

// Also if the error of the rotation is zero or nearly π, and if the biases need no correction.
TEST(InertialBetween, HasCorrectJacobiansForAnyErrorOfTheRotation) {
  RandomNumbers random(5);
  for (const double angle : {0.0, 1e-9, 1e-5, 5e-3, 0.1, 3.0, 3.14}) {
    const InertialMotion motion = random_motion(random);
    const SE3 begin = random_pose(random, 1);
    const Vector3 velocity = random_vector(random);
    const InertialState end = motion.predict(begin, velocity, motion.bias, Vector3(0, 0, -9));
    const SE3 turned = end.pose * pose(0, 0, 0, 0.6 * angle, 0, 0.8 * angle);
    expect_correct_jacobians(InertialBetween(motion), begin, velocity, motion.bias, turned, end.velocity,
                             motion.bias);
  }
}

TEST(InertialBetween, UsesAnalyticJacobians) {
  Graph graph;
  const auto x = graph.add_vertex(SE3()), y = graph.add_vertex(SE3());
  const auto v = graph.add_vertex(Vector3(0, 0, 0)), w = graph.add_vertex(Vector3(0, 0, 0));
  const auto b = graph.add_vertex(ImuBias(ImuBias::Zero())), c = graph.add_vertex(ImuBias(ImuBias::Zero()));
  graph.add_edge(InertialBetween(InertialMotion{}), x, v, b, y, w, c);
  EXPECT_EQ(graph.edge_pools()[0]->jacobian_source(), detail::JacobianSource::kAnalytic);
}

/// A sum of `samples` χ² variables with `dim` degrees of freedom has mean samples·dim and variance twice
/// that.
void expect_consistent(double sum, int samples, int dim, const char* what) {
  const double n = samples * dim;
  EXPECT_NEAR(sum, n, 5 * std::sqrt(2 * n)) << what;
}

TEST(InertialBetween, WithACameraEndsAtErrorsThatTheCovarianceExplains) {
  constexpr int kRuns = 60;
  double poses = 0, velocities = 0, biases = 0, chi2 = 0, degrees = 0;
  for (int run = 0; run < kRuns; ++run) {
    InertialGraph flight(
        {.seconds = 8, .imu_rate = 100, .landmarks = 50, .seed = static_cast<std::uint64_t>(run + 1)});
    flight.add_motions();
    flight.add_landmarks();
    const Report report = optimize(flight.graph);
    ASSERT_TRUE(report.converged()) << report.message;
    chi2 += report.chi2_final;
    degrees += static_cast<double>(report.degrees_of_freedom);

    const auto& truth = flight.simulation.keyframes.back();
    const Covariance covariance = marginal_covariances(
        flight.graph,
        std::vector<VertexRef>{flight.poses.back(), flight.velocities.back(), flight.biases.back()});
    ASSERT_TRUE(covariance.ok()) << covariance.message();
    poses += squared_error(flight.graph, covariance, flight.poses.back(), truth.true_state.pose);
    velocities +=
        squared_error(flight.graph, covariance, flight.velocities.back(), truth.true_state.velocity);
    biases += squared_error(flight.graph, covariance, flight.biases.back(), truth.true_bias);
  }
  expect_consistent(poses, kRuns, 6, "poses");
  expect_consistent(velocities, kRuns, 3, "velocities");
  expect_consistent(biases, kRuns, 6, "biases");
  EXPECT_NEAR(chi2, degrees, 5 * std::sqrt(2 * degrees));
}

// The first pose is fixed, so its roll and pitch are relative to a world whose vertical is not known.
TEST(InertialBetween, FindsTheDirectionOfGravity) {
  InertialGraph flight({.seconds = 10, .imu_rate = 100, .landmarks = 80, .seed = 7});
  const auto down = flight.graph.add_vertex(S2(Vector3(0.3, -0.2, -1)));
  flight.add_motions(down);
  flight.add_landmarks();
  expect_chi2_of_noise(flight.graph);
  expect_truth(flight.graph, down, S2(Vector3(0, 0, -1)));
  EXPECT_LT((flight.graph.estimate(down).vector() - Vector3(0, 0, -1)).norm(), 0.01);
}

}  // namespace
}  // namespace boxplus
