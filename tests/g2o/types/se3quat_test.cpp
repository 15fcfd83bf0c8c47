// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam3d/se3quat.h"

#include <gtest/gtest.h>

#include <unsupported/Eigen/MatrixFunctions>

#include "g2o/types/slam3d/isometry3d_mappings.h"

namespace {

using g2o::SE3Quat;
using g2o::Vector6;

Vector6 tangent(double size) {
  Vector6 v;
  v << 0.3, -0.2, 0.5, 1, -2, 3;
  return size * v;
}

TEST(SE3Quat, TheExponentialEqualsTheMatrixExponential) {
  for (const double size : {0., 1e-9, 1e-3, 1., 4.}) {
    const Vector6 v = tangent(size);
    g2o::Matrix4 generator = g2o::Matrix4::Zero();
    generator.topLeftCorner<3, 3>() = g2o::skew(v.head<3>());
    generator.topRightCorner<3, 1>() = v.tail<3>();
    const g2o::Matrix4 expected = generator.exp();
    EXPECT_LT((SE3Quat::exp(v).to_homogeneous_matrix() - expected).norm(), 1e-12);
  }
}

TEST(SE3Quat, TheLogarithmIsTheInverseOfTheExponential) {
  for (const double size : {0., 1e-9, 1e-3, 1., 4.}) {
    EXPECT_LT((SE3Quat::exp(tangent(size)).log() - tangent(size)).norm(), 1e-11 * (1 + size));
  }
}

TEST(SE3Quat, TheAdjointTransformsTangentVectors) {
  const SE3Quat T = SE3Quat::exp(tangent(1));
  Vector6 delta;
  delta << 0.1, 0.2, -0.1, 0.3, -0.4, 0.2;
  const SE3Quat left = SE3Quat::exp(T.adj() * delta), right = T * SE3Quat::exp(delta) * T.inverse();
  EXPECT_LT((left.to_homogeneous_matrix() - right.to_homogeneous_matrix()).norm(), 1e-12);
}

TEST(SE3Quat, ConvertsToVectorsAndToIsometriesAndBack) {
  const SE3Quat T = SE3Quat::exp(tangent(1));
  SE3Quat other;
  other.fromVector(T.toVector());
  EXPECT_LT((other.toVector() - T.toVector()).norm(), 1e-15);
  other.fromMinimalVector(T.toMinimalVector());
  EXPECT_LT((other.toVector() - T.toVector()).norm(), 1e-15);
  EXPECT_LT((SE3Quat(T.toVector()).map({1, 2, 3}) - T * g2o::Vector3(1, 2, 3)).norm(), 1e-15);
  const g2o::Isometry3 motion = T;
  EXPECT_LT((g2o::internal::toSE3Quat(motion).toVector() - T.toVector()).norm(), 1e-15);
  EXPECT_LT(
      (g2o::internal::fromVectorMQT(g2o::internal::toVectorMQT(motion)).matrix() - motion.matrix()).norm(),
      1e-15);
  EXPECT_LT(
      (g2o::internal::fromVectorET(g2o::internal::toVectorET(motion)).matrix() - motion.matrix()).norm(),
      1e-15);
}

}  // namespace
