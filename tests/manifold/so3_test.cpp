// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/manifold/so3.h"

#include <gtest/gtest.h>

#include "boxplus/manifold/angle.h"
#include "boxplus/testing/check_manifold.h"
#include "manifold/samples.h"

namespace boxplus {
namespace {

template <class T>
class RotationTest : public testing::Test {
 protected:
  T random() { return T::from_rotation_vector(samples_.vector<3>(1.8)); }
  Samples samples_;
};
using Charts = testing::Types<SO3, SO3RotationVector>;
TYPED_TEST_SUITE(RotationTest, Charts);

TYPED_TEST(RotationTest, ObeysTheManifoldLaws) {
  auto rotations = Samples::many(12, [&] { return this->random(); });
  rotations.push_back(TypeParam());
  rotations.push_back(TypeParam::from_rotation_vector(Vector<double, 3>(3.1, 0, 0)));
  rotations.push_back(TypeParam::from_rotation_vector(Vector<double, 3>(0, 1e-5, 0)));
  const ManifoldCheck check = check_manifold(rotations);
  EXPECT_TRUE(check) << check.message;
}

TYPED_TEST(RotationTest, ObeysTheManifoldLawsForLargeAndTinySteps) {
  const auto rotations = Samples::many(6, [&] { return this->random(); });
  for (const double step : {0.5, 0.02, 0.005, 1e-4}) {
    ManifoldCheckOptions options;
    options.step = step;
    const ManifoldCheck check = check_manifold(rotations, options);
    EXPECT_TRUE(check) << check.message << ", step " << step;
  }
}

TYPED_TEST(RotationTest, IsUnchangedBitForBitByAZeroStep) {
  const double zero[3] = {0, 0, 0};
  for (int i = 0; i < 1000; ++i) {
    const TypeParam x = this->random() * this->random();
    const TypeParam y = Manifold<TypeParam>::oplus(x, zero);
    for (int k = 0; k < 4; ++k) EXPECT_EQ(x.data()[k], y.data()[k]);
  }
}

TYPED_TEST(RotationTest, StaysAUnitQuaternionOverManySteps) {
  TypeParam x;
  const double delta[3] = {0.3, -0.2, 0.1};
  for (int i = 0; i < 100000; ++i) x = Manifold<TypeParam>::oplus(x, delta) * x;
  EXPECT_NEAR(x.quaternion().squared_norm(), 1, 2e-15);
}

TYPED_TEST(RotationTest, HasExactJacobiansFromDualNumbers) {
  const TypeParam x = this->random(), y = this->random();
  const auto error = [&](const auto& z) { return (y.inverse() * z).rotation_vector(); };
  Matrix<double, 3, 3> numeric;
  detail::numeric_jacobian(error, x, numeric);
  EXPECT_LT((dual_jacobian<3>(error, x) - numeric).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((dual_jacobian<3>(error, y) -
             Matrix<double, 3, 3>::Identity() * (std::is_same_v<TypeParam, SO3> ? 2 : 1))
                .norm(),
            1e-15)
      << "at zero error";
}

TYPED_TEST(RotationTest, HasExactSecondDerivativesAtZero) {
  using D = detail::Dual<double, 3>;
  using H = detail::Dual<D, 3>;
  H delta[3];
  for (int i = 0; i < 3; ++i) {
    delta[i] = H(D::variable(0, i));
    delta[i].derivative[i] = D(1);
  }
  const Vector<H, 3> p = Manifold<TypeParam>::oplus(TypeParam(), delta) * Vector<double, 3>(1, 0, 0);
  // R(ω) = I + [ω]× + ½[ω]×² + …, and the vector part of a quaternion is ω/2 up to third order.
  const double unit = std::is_same_v<TypeParam, SO3> ? 4 : 1;
  EXPECT_NEAR(p[0].derivative[1].derivative[1], -unit, 1e-14);
  EXPECT_NEAR(p[0].derivative[0].derivative[0], 0, 1e-14);
  EXPECT_NEAR(p[1].derivative[0].derivative[1], unit / 2, 1e-14);
}

TYPED_TEST(RotationTest, ComposesLikeItsMatrices) {
  const TypeParam a = this->random(), b = this->random();
  const Vector<double, 3> p(0.3, -2, 5);
  EXPECT_LT(((a * b).rotation() - a.rotation() * b.rotation()).norm(), 1e-14);
  EXPECT_LT((a * p - a.rotation() * p).norm(), 1e-14);
  EXPECT_LT((a.inverse().rotation() - a.rotation().transpose()).norm(), 1e-14);
}

TEST(SO3, RecoversTheQuaternionOfEveryRotationMatrix) {
  Samples s;
  for (int i = 0; i < 200; ++i) {
    const SO3 x = SO3::from_rotation_vector(s.vector<3>(3));
    EXPECT_LT((SO3(x.rotation()).rotation() - x.rotation()).norm(), 1e-14);
  }
  for (int axis = 0; axis < 3; ++axis) {
    const SO3 half_turn = SO3::from_rotation_vector(Vector<double, 3>(Vector<double, 3>::Unit(axis) * kPi));
    EXPECT_LT((SO3(half_turn.rotation()).rotation() - half_turn.rotation()).norm(), 1e-14);
  }
}

TEST(SO3, KeepsAUnitQuaternionBitForBitAndNormalizesOthers) {
  const SO3 kept(detail::Quaternion<double>{0.1, 0.2, 0.3, std::sqrt(1 - 0.14)});
  EXPECT_EQ(kept.data()[0], 0.1);
  const SO3 normalized(detail::Quaternion<double>{0, 0, 3, 4});
  EXPECT_DOUBLE_EQ(normalized.data()[2], 0.6);
  EXPECT_EQ(SO3(detail::Quaternion<double>{0, 0, 0, 0}).data()[3], 1);
}

}  // namespace
}  // namespace boxplus
