// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/manifold/convert_to.h"

#include <gtest/gtest.h>

#include <concepts>

namespace boxplus {
namespace {

/// Types with the part of the interface of Sophus that the documentation of convert_to() requires.
namespace sophus {
template <class S>
class SO2 {
 public:
  using Scalar = S;
  explicit SO2(const S& theta) : complex_(std::cos(theta), std::sin(theta)) {}
  const Eigen::Matrix<S, 2, 1>& unit_complex() const { return complex_; }

 private:
  Eigen::Matrix<S, 2, 1> complex_;
};

template <class S>
class SE2 {
 public:
  using Scalar = S;
  SE2(const S& theta, const Eigen::Matrix<S, 2, 1>& p) : so2_(theta), translation_(p) {}
  const SO2<S>& so2() const { return so2_; }
  const Eigen::Matrix<S, 2, 1>& unit_complex() const { return so2_.unit_complex(); }
  const Eigen::Matrix<S, 2, 1>& translation() const { return translation_; }

 private:
  SO2<S> so2_;
  Eigen::Matrix<S, 2, 1> translation_;
};

template <class S>
class SO3 {
 public:
  using Scalar = S;
  template <class D>
  explicit SO3(const Eigen::QuaternionBase<D>& q) : quaternion_(q.normalized()) {}
  const Eigen::Quaternion<S>& unit_quaternion() const { return quaternion_; }

 private:
  Eigen::Quaternion<S> quaternion_;
};

template <class S>
class SE3 {
 public:
  using Scalar = S;
  template <class D, class E>
  SE3(const Eigen::QuaternionBase<D>& q, const Eigen::MatrixBase<E>& t) : so3_(q), translation_(t) {}
  const SO3<S>& so3() const { return so3_; }
  const Eigen::Quaternion<S>& unit_quaternion() const { return so3_.unit_quaternion(); }
  const Eigen::Matrix<S, 3, 1>& translation() const { return translation_; }

 private:
  SO3<S> so3_;
  Eigen::Matrix<S, 3, 1> translation_;
};

/// A similarity. The squared norm of its quaternion is its scale.
template <class S>
class Sim3 {
 public:
  using Scalar = S;
  template <class D, class E>
  Sim3(const Eigen::QuaternionBase<D>& q, const Eigen::MatrixBase<E>& t) : quaternion_(q), translation_(t) {}
  const Eigen::Quaternion<S>& quaternion() const { return quaternion_; }
  const Eigen::Matrix<S, 3, 1>& translation() const { return translation_; }
  S scale() const { return quaternion_.squaredNorm(); }

 private:
  Eigen::Quaternion<S> quaternion_;
  Eigen::Matrix<S, 3, 1> translation_;
};
}  // namespace sophus

constexpr double kRounding = 1e-14;
const Vector3 kPoint(0.3, -2, 5);
const Vector2 kPoint2(0.3, -2);

const detail::Quaternion<double> kRotation =
    detail::normalized(detail::Quaternion<double>{0.1, -0.7, 0.3, -0.4});
const SE3 kPose(Vector3(1, -2, 3), kRotation);

template <class A, class B>
void expect_same_point(const A& a, const B& b) {
  EXPECT_LT((Eigen::VectorXd(a) - Eigen::VectorXd(b)).norm(), kRounding)
      << a.transpose() << " / " << b.transpose();
}

TEST(ConvertTo, Isometries3dMoveAPointLikeTheirPose) {
  const auto isometry = convert_to<Eigen::Isometry3d>(kPose);
  expect_same_point((isometry * Eigen::Vector3d(kPoint)).eval(), kPose * kPoint);
  expect_same_point(convert_to<SE3>(isometry) * kPoint, kPose * kPoint);
  expect_same_point(convert_to<SE3RotationVector>(isometry) * kPoint, kPose * kPoint);
}

TEST(ConvertTo, Isometries2dMoveAPointLikeTheirPose) {
  for (const double angle : {0.0, 1.0, -2.5, kPi}) {
    const SE2 pose(1, -2, angle);
    const auto isometry = convert_to<Eigen::Isometry2d>(pose);
    expect_same_point((isometry * Eigen::Vector2d(kPoint2)).eval(), pose * kPoint2);
    EXPECT_NEAR(convert_to<SE2>(isometry).theta(), pose.theta(), kRounding);
    expect_same_point(convert_to<SE2>(isometry) * kPoint2, pose * kPoint2);
  }
}

TEST(ConvertTo, RotationsConvertFromAndToQuaternionsAnglesAndAxes) {
  const Eigen::Quaterniond q = Eigen::Quaterniond(0.5, -0.1, 0.7, 0.2).normalized();
  expect_same_point(convert_to<SO3>(q) * kPoint, (q * Eigen::Vector3d(kPoint)).eval());
  expect_same_point(convert_to<Eigen::Quaterniond>(convert_to<SO3RotationVector>(q)).coeffs(), q.coeffs());
  const Eigen::AngleAxisd turn(2.0, Eigen::Vector3d(1, 2, 2) / 3);
  expect_same_point(convert_to<SO3>(turn).rotation_vector(), Vector3(2.0 / 3, 4.0 / 3, 4.0 / 3));
  expect_same_point((convert_to<Eigen::AngleAxisd>(convert_to<SO3>(turn)) * Eigen::Vector3d(kPoint)).eval(),
                    (turn * Eigen::Vector3d(kPoint)).eval());
  EXPECT_EQ(convert_to<SO2>(Eigen::Rotation2Dd(0.7)).angle(), 0.7);
  EXPECT_EQ(convert_to<Eigen::Rotation2Dd>(SO2(-2.0)).angle(), -2);
  EXPECT_NEAR(convert_to<SO2>(Eigen::Rotation2Dd(7)).angle(), 7 - 2 * kPi, kRounding);
}

TEST(ConvertTo, QuaternionsAreNormalized) {
  expect_same_point(convert_to<SO3>(Eigen::Quaterniond(2, 0, 0, 2)).rotation_vector(),
                    Vector3(0, 0, kPi / 2));
  // The quaternion of a pose from a file with few digits is not exactly normalized, but its isometry is
  // orthogonal.
  const SE3 rounded = SE3::from_unit(Vector3(1, 2, 3), detail::Quaternion<double>{0, 0, 0.707107, 0.707107});
  const Eigen::Matrix3d R = convert_to<Eigen::Isometry3d>(rounded).linear();
  EXPECT_LT((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), kRounding);
  EXPECT_EQ(convert_to<SE3RotationVector>(rounded).vector(), rounded.vector());
}

TEST(ConvertTo, SimilaritiesConvertFromAndToAffineMaps) {
  const Sim3 x(kRotation, Vector3(1, -2, 3), 0.25);
  const auto affine = convert_to<Eigen::Affine3d>(x);
  expect_same_point((affine * Eigen::Vector3d(kPoint)).eval(), x * kPoint);
  EXPECT_NEAR(convert_to<Sim3>(affine).scale(), 0.25, kRounding);
  expect_same_point(convert_to<Sim3>(affine) * kPoint, x * kPoint);
  expect_same_point(convert_to<Sim3>(convert_to<Eigen::Isometry3d>(kPose)) * kPoint, kPose * kPoint);
  EXPECT_EQ(convert_to<Sim3>(kPose).scale(), 1);
}

TEST(ConvertTo, TypesWithTheInterfaceOfSophusConvertBothWays) {
  EXPECT_NEAR(convert_to<SO2>(convert_to<sophus::SO2<double>>(SO2(2.5))).angle(), 2.5, kRounding);
  const SE2 pose2(1, -2, 2.5);
  const auto plane = convert_to<sophus::SE2<double>>(pose2);
  expect_same_point(plane.translation(), pose2.translation());
  expect_same_point(convert_to<SE2>(plane).vector(), pose2.vector());
  const auto turn = convert_to<sophus::SO3<double>>(kPose.so3());
  expect_same_point(convert_to<SO3>(turn) * kPoint, kPose.so3() * kPoint);
  const auto space = convert_to<sophus::SE3<double>>(kPose);
  expect_same_point(space.so3().unit_quaternion() * Eigen::Vector3d(kPoint) + space.translation(),
                    kPose * kPoint);
  expect_same_point(convert_to<SE3>(space).vector(), kPose.vector());
  const Sim3 similar(kRotation, Vector3(1, -2, 3), 4);
  const auto there = convert_to<sophus::Sim3<double>>(similar);
  EXPECT_NEAR(there.scale(), 4, kRounding);
  expect_same_point(convert_to<Sim3>(there) * kPoint, similar * kPoint);
}

TEST(ConvertTo, AcceptsSinglePrecision) {
  const auto isometry = convert_to<Eigen::Isometry3f>(kPose);
  EXPECT_LT((convert_to<SE3>(isometry).translation() - kPose.translation()).norm(), 1e-6);
  EXPECT_NEAR(convert_to<SE3>(isometry).quaternion().squared_norm(), 1, 1e-15);
  const auto like_sophus = convert_to<sophus::SE3<float>>(kPose);
  EXPECT_LT((convert_to<SE3>(like_sophus) * kPoint - kPose * kPoint).norm(), 1e-5);
}

template <class To, class From>
concept Converts = requires(const From& x) {
  { convert_to<To>(x) } -> std::same_as<To>;
};

TEST(ConvertTo, RefusesToDropAPartOfATransformation) {
  EXPECT_TRUE((Converts<SE3, Eigen::Quaterniond>));
  EXPECT_FALSE((Converts<Eigen::Quaterniond, SE3>)) << "would drop the translation";
  EXPECT_FALSE((Converts<Eigen::Isometry3d, Sim3>)) << "would drop the scale";
  EXPECT_FALSE((Converts<SE3, Eigen::Affine3d>)) << "would drop the scale";
  EXPECT_FALSE((Converts<SO2, Eigen::Isometry2d>)) << "would drop the translation";
  EXPECT_FALSE((Converts<SE3, SE2>)) << "one is a pose in space, the other is a pose in the plane";
  EXPECT_FALSE((Converts<SE3, Vector3>)) << "a vector is not a pose";
}

}  // namespace
}  // namespace boxplus
