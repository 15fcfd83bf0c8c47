// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/hand_eye.h"

#include <gmock/gmock.h>

#include "types/inertial/inertial_graph.h"
#include "types/slam3d/sensor_world.h"

namespace boxplus {
namespace {

const SE3 kMount = pose(0.1, -0.2, 0.3, 0.5, -1, 2), kTarget = pose(2, 1, 0.5, -1, 0.2, 0.4);

TEST(HandEye, IsZeroIfBothMotionsAreOne) {
  const SE3 hand = pose(1, 2, 3, 0.3, 0.4, -0.5);
  const HandEye<SE3> motion(hand, kMount.inverse() * hand * kMount);
  EXPECT_LT(motion.error(kMount).norm(), 1e-14);
  const HandEye<SE3> place(hand, kTarget.inverse() * hand * kMount);
  EXPECT_LT(place.error(kMount, kTarget).norm(), 1e-14);
}

TEST(HandEye, MeasuresInTheFrameOfTheEyeAtTheSecondTime) {
  // The hand turns by 90°. The eye is 1 m ahead of it, and says that it has not moved.
  const Vector<double, 3> e = HandEye<SE2>(SE2(0, 0, kPi / 2), SE2()).error(SE2(1, 0, 0));
  EXPECT_LT((e - Vector3(-1, -1, -kPi / 2)).norm(), 1e-14);
}

TEST(HandEye, HasCorrectJacobiansAtRandomStates) {
  RandomNumbers random(1);
  for (int trial = 0; trial < 1000; ++trial) {
    const HandEye<SE3> edge(random_pose(random, 2), random_pose(random, 2));
    const SE3 x = random_pose(random, 2), z = random_pose(random, 2);
    expect_correct_jacobians(edge, x);
    expect_correct_jacobians(edge, x, z);
    const Vector3 a = random_vector(random), b = random_vector(random);
    expect_correct_jacobians(HandEye<SE2>(SE2(a[0], a[1], a[2]), SE2(b[0], b[1], b[2])),
                             SE2(b[1], a[2], b[0]));
  }
}

constexpr double kTranslation = 0.005, kRotation = 0.003;

SE3 noise(RandomNumbers& random) {
  Vector<double, 6> step;
  for (double& value : step) value = random.normal();
  step.head<3>() *= kTranslation;
  step.tail<3>() *= kRotation / 2;  // the vector part of a quaternion is half an angle
  return Manifold<SE3>::oplus(SE3(), step.data());
}

TEST(HandEye, EndsAtTheTrueMount) {
  RandomNumbers random(2);
  Graph graph;
  const auto mount = graph.add_vertex(SE3());
  for (int k = 0; k < 100; ++k) {
    const SE3 hand = random_pose(random, 1);
    const HandEye<SE3> edge(hand, kMount.inverse() * hand * kMount * noise(random));
    graph.add_edge(edge, Information::se3_sigmas(kTranslation, kRotation), mount);
  }
  expect_chi2_of_noise(graph);
  expect_truth(graph, mount, kMount);
  EXPECT_LT((graph.estimate(mount).vector() - kMount.vector()).norm(), 0.01);
}

TEST(HandEye, EndsAtTheTrueMountAndTheTrueTarget) {
  RandomNumbers random(3);
  Graph graph;
  const auto mount = graph.add_vertex(kMount * random_pose(random, 0.3)),
             target = graph.add_vertex(kTarget * random_pose(random, 0.3));
  for (int k = 0; k < 100; ++k) {
    const SE3 hand = random_pose(random, 1);
    const HandEye<SE3> edge(hand, kTarget.inverse() * hand * kMount * noise(random));
    graph.add_edge(edge, Information::se3_sigmas(kTranslation, kRotation), mount, target);
  }
  expect_chi2_of_noise(graph);
  expect_truth(graph, mount, kMount);
  expect_truth(graph, target, kTarget);
}

}  // namespace
}  // namespace boxplus
