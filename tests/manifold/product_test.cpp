// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/manifold/product.h"

#include <gtest/gtest.h>

#include "boxplus/manifold/rn.h"
#include "boxplus/manifold/s2.h"
#include "boxplus/manifold/se3.h"
#include "boxplus/testing/check_manifold.h"
#include "manifold/samples.h"

namespace boxplus {
namespace {

using NavigationState = Product<SE3, Vector<double, 3>, double>;

NavigationState random_state(Samples& s) {
  return NavigationState(SE3(s.vector<3>(10), SO3::from_rotation_vector(s.vector<3>(1.8))), s.vector<3>(1),
                         s.uniform(-1, 1));
}

TEST(Product, ObeysTheManifoldLaws) {
  Samples s;
  const ManifoldCheck check = check_manifold(Samples::many(6, [&] { return random_state(s); }));
  EXPECT_TRUE(check) << check.message;
}

TEST(Product, ObeysTheManifoldLawsIfAPartHasRunTimeSize) {
  const Product bias(S2(), Eigen::VectorXd(Eigen::VectorXd::LinSpaced(4, 0, 1)), 2.0);
  static_assert(Manifold<std::decay_t<decltype(bias)>>::kDim == kDynamic);
  EXPECT_EQ(detail::tangent_dim(bias), 2 + 4 + 1);
  const ManifoldCheck check = check_manifold(bias);
  EXPECT_TRUE(check) << check.message;
}

TEST(Product, ConcatenatesTheTangentsOfItsPartsInOrder) {
  static_assert(Manifold<NavigationState>::kDim == 10);
  const double delta[10] = {0, 0, 0, 0, 0, 0, 1, 2, 3, 4};
  const NavigationState x = Manifold<NavigationState>::oplus(NavigationState(SE3(), {0, 0, 0}, 0), delta);
  EXPECT_EQ(x.get<1>(), (Vector<double, 3>(1, 2, 3)));
  EXPECT_EQ(x.get<2>(), 4);
}

TEST(Product, UnpacksIntoItsParts) {
  NavigationState x(SE3(), {1, 2, 3}, 5);
  auto& [pose, velocity, bias] = x;
  bias = 7;
  EXPECT_EQ(x.get<2>(), 7);
  EXPECT_EQ(velocity[1], 2);
  EXPECT_EQ(pose.quaternion().w, 1);
}

TEST(Product, HasExactJacobiansFromDualNumbers) {
  Samples s;
  const NavigationState x = random_state(s);
  const auto error = [](const auto& state) {
    const auto& [pose, velocity, bias] = state;
    return (pose * velocity * bias).eval();
  };
  Matrix<double, 3, 10> numeric;
  detail::numeric_jacobian(error, x, numeric);
  EXPECT_LT((dual_jacobian<3>(error, x) - numeric).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(Product, MayContainAnotherProduct) {
  const Product nested(Product(1.0, 2.0), S2());
  EXPECT_EQ(detail::tangent_dim(nested), 4);
  const ManifoldCheck check = check_manifold(nested);
  EXPECT_TRUE(check) << check.message;
}

}  // namespace
}  // namespace boxplus
