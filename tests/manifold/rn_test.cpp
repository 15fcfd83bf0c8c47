// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/manifold/rn.h"

#include <gtest/gtest.h>

#include "boxplus/testing/check_manifold.h"
#include "manifold/samples.h"

namespace boxplus {
namespace {

TEST(Rn, ObeysTheManifoldLawsForEveryKindOfEigenVector) {
  Samples s;
  const auto expect_laws = [](const auto& x) {
    const ManifoldCheck check = check_manifold(x);
    EXPECT_TRUE(check) << check.message;
  };
  expect_laws(s.vector<1>(10));
  expect_laws(s.vector<3>(10));
  expect_laws(Eigen::Vector2d(1, 2));
  expect_laws(Eigen::Vector4d(1, 2, 3, 4));
  expect_laws(Eigen::VectorXd(Eigen::VectorXd::LinSpaced(5, 1, 2)));
  expect_laws(Vector<double, kDynamic>(Eigen::VectorXd::LinSpaced(5, 1, 2)));
  expect_laws(3.5);
}

TEST(Rn, HasATangentDimensionEqualToItsSize) {
  static_assert(Manifold<double>::kDim == 1);
  static_assert(Manifold<Eigen::Vector3d>::kDim == 3);
  static_assert(Manifold<Eigen::VectorXd>::kDim == kDynamic);
  EXPECT_EQ(detail::tangent_dim(Eigen::VectorXd(7)), 7);
}

TEST(Rn, KeepsItsEigenOptionsIfItIsConvertedToDualNumbers) {
  using D = detail::Dual<double, 3>;
  static_assert(std::is_same_v<detail::Rebind<Eigen::Vector3d, D>, Eigen::Matrix<D, 3, 1>>);
  static_assert(std::is_same_v<detail::Rebind<Vector<double, 3>, D>, Vector<D, 3>>);
}

TEST(Rn, RefusesTheDifferenceOfVectorsOfTwoSizes) {
  double delta[5];
  using M = Manifold<Eigen::VectorXd>;
  EXPECT_THROW(M::ominus(Eigen::VectorXd::Zero(3), Eigen::VectorXd::Zero(5), delta), InvalidArgument);
  EXPECT_THROW(M::ominus(Eigen::VectorXd::Zero(5), Eigen::VectorXd::Zero(3), delta), InvalidArgument);
}

TEST(Rn, AddsTheTangent) {
  const double delta[] = {0.5, 0.25};
  EXPECT_EQ((Manifold<Eigen::Vector2d>::oplus({1, 2}, delta)), Eigen::Vector2d(1.5, 2.25));
  EXPECT_EQ(Manifold<double>::oplus(1, delta), 1.5);
}

}  // namespace
}  // namespace boxplus
