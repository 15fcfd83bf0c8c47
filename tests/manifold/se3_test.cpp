// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/manifold/se3.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "boxplus/testing/check_manifold.h"
#include "manifold/samples.h"

namespace boxplus {
namespace {

template <class T>
class PoseTest : public testing::Test {
 protected:
  T random() {
    return T(samples_.vector<3>(10), decltype(T().so3())::from_rotation_vector(samples_.vector<3>(1.8)));
  }
  Samples samples_;
};
using Charts = testing::Types<SE3, SE3RotationVector>;
TYPED_TEST_SUITE(PoseTest, Charts);

TYPED_TEST(PoseTest, ObeysTheManifoldLaws) {
  auto poses = Samples::many(10, [&] { return this->random(); });
  poses.push_back(TypeParam());
  for (const double step : {0.4, 0.1, 0.005}) {
    ManifoldCheckOptions options;
    options.step = step;
    const ManifoldCheck check = check_manifold(poses, options);
    EXPECT_TRUE(check) << check.message << ", step " << step;
  }
}

TYPED_TEST(PoseTest, HasExactJacobiansOfTheErrorOfARelativePose) {
  const TypeParam a = this->random(), b = this->random(), measurement = this->random();
  const auto error_of_a = [&](const auto& x) {
    return (measurement.inverse() * x.inverse_times(b)).minimal();
  };
  const auto error_of_b = [&](const auto& x) {
    return (measurement.inverse() * (a.inverse() * x)).minimal();
  };
  Matrix<double, 6, 6> numeric;
  detail::numeric_jacobian(error_of_a, a, numeric);
  EXPECT_LT((dual_jacobian<6>(error_of_a, a) - numeric).cwiseAbs().maxCoeff(), 1e-9);
  detail::numeric_jacobian(error_of_b, b, numeric);
  EXPECT_LT((dual_jacobian<6>(error_of_b, b) - numeric).cwiseAbs().maxCoeff(), 1e-9);
}

TYPED_TEST(PoseTest, HasTheSameDerivativesWhetherOrNotItIsFirstConvertedToDualNumbers) {
  using D = detail::Dual<double, 6>;
  const TypeParam x = this->random();
  D delta[6];
  for (int i = 0; i < 6; ++i) delta[i] = D::variable(0.1 * i, i);
  const auto direct = Manifold<TypeParam>::oplus(x, delta);
  const auto cast = Manifold<detail::Rebind<TypeParam, D>>::oplus(x.template cast<D>(), delta);
  for (int c = 0; c < 7; ++c) {
    EXPECT_DOUBLE_EQ(direct.data()[c].value, cast.data()[c].value);
    for (int i = 0; i < 6; ++i)
      EXPECT_NEAR(direct.data()[c].derivative[i], cast.data()[c].derivative[i], 1e-15);
  }
}

TYPED_TEST(PoseTest, ComposesLikeItsMatrices) {
  const TypeParam a = this->random(), b = this->random();
  const Vector<double, 3> p(0.3, -2, 5);
  EXPECT_LT(((a * b) * p - a * (b * p)).norm(), 1e-13);
  EXPECT_LT((a * p - (a.rotation() * p + a.translation())).norm(), 1e-13);
  EXPECT_LT((a.inverse() * (a * p) - p).norm(), 1e-13);
  EXPECT_LT((a.inverse_times(p) - a.inverse() * p).norm(), 1e-13);
  EXPECT_LT((a.inverse_times(b).vector() - (a.inverse() * b).vector()).norm(), 1e-13);
}

TEST(SE3, StoresSevenScalarsInTheOrderOfG2oFiles) {
  static_assert(sizeof(SE3) == 7 * sizeof(double) && alignof(SE3) == alignof(double));
  static_assert(std::is_trivially_copyable_v<SE3>);
  Vector<double, 7> v;
  v << 1, 2, 3, 0, 0, 0.6, 0.8;
  EXPECT_EQ(SE3::from_vector(v).vector(), v);
  EXPECT_EQ(SE3::from_vector(v).data()[5], 0.6);
}

TEST(SE3, MinimalIsTranslationAndQuaternionVectorWithNonNegativeW) {
  Vector<double, 7> v;
  v << 1, 2, 3, 0, 0, 0.6, -0.8;
  Vector<double, 6> expected;
  expected << 1, 2, 3, 0, 0, -0.6;
  EXPECT_EQ(SE3::from_vector(v).minimal(), expected);
  EXPECT_LT((SE3::from_minimal(expected).rotation() - SE3::from_vector(v).rotation()).norm(), 1e-15);
}

TEST(SE3, MovesInItsOwnFrameByTranslationAndQuaternionVector) {
  const SE3 x(Vector<double, 3>(1, 1, 1), detail::Quaternion<double>{0, 0, std::sqrt(0.5), std::sqrt(0.5)});
  const double delta[6] = {1, 0, 0, 0, 0, 0.6};
  const SE3 y = Manifold<SE3>::oplus(x, delta);
  EXPECT_NEAR(y.translation()[1], 2, 1e-15);
  EXPECT_NEAR(y.quaternion().w, std::sqrt(0.5) * (0.8 - 0.6), 1e-15);
}

TYPED_TEST(PoseTest, HasAnExponentialWhoseInverseIsTheLogarithm) {
  for (const double angle : {0.0, 1e-9, 0.009, 0.011, 1.0, 3.1}) {
    Vector<double, 6> v;
    v << 1, -2, 3, angle * Vector<double, 3>(2, -1, 2) / 3;
    const TypeParam x = TypeParam::exp(v);
    EXPECT_LT((x.log() - v).norm(), 1e-13) << angle;
    const TypeParam half = TypeParam::exp(0.5 * v);
    EXPECT_LT(((half * half).vector() - x.vector()).norm(), 1e-14) << angle;
  }
}

TEST(SE3, MovesOnACircleIfItsVelocitiesAreConstant) {
  Vector<double, 6> v;  // a quarter of a circle with radius 2, to the left
  v << kPi, 0, 0, 0, 0, kPi / 2;
  EXPECT_LT((SE3::exp(v).translation() - Vector<double, 3>(2, 2, 0)).norm(), 1e-15);
}

TEST(SE3, TakesAQuaternionOfEigen) {
  const Eigen::Quaterniond q(0.8, 0, 0, 0.6);
  Vector<double, 7> v;
  v << 1, 2, 3, 0, 0, 0.6, 0.8;
  EXPECT_EQ(SE3(Vector<double, 3>(1, 2, 3), q).vector(), v);
}

}  // namespace
}  // namespace boxplus
