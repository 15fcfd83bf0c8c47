// SPDX-License-Identifier: BSD-3-Clause
// Compares the shortcuts of manifolds with ⊞ over dual numbers.
#include "boxplus/manifold/lift.h"

#include <gtest/gtest.h>

#include <tuple>
#include <type_traits>
#include <vector>

#include "boxplus/manifold/product.h"
#include "boxplus/manifold/rn.h"
#include "boxplus/manifold/s2.h"
#include "boxplus/manifold/se2.h"
#include "boxplus/manifold/se3.h"
#include "boxplus/manifold/so3.h"
#include "manifold/samples.h"

namespace boxplus {
namespace {

using D = detail::Dual<double, 8>;
using Pair = Product<SE3, Vector<double, 2>>;
using Nested = Product<Product<SE2, double>, S2, SO3>;

/// Appends the numbers of a lifted estimate.
template <class X>
void append(const X& x, std::vector<D>& numbers) {
  if constexpr (std::is_same_v<X, D>) {
    numbers.push_back(x);
  } else if constexpr (requires { x.parts; }) {
    std::apply([&](const auto&... part) { (append(part, numbers), ...); }, x.parts);
  } else {
    numbers.insert(numbers.end(), x.data(), x.data() + sizeof(X) / sizeof(D));
  }
}

/// x ⊞ δ by dual numbers, where δ[k] is the variable `offset + k`, if there is one.
template <class T>
detail::Rebind<T, D> moved(const T& x, int offset) {
  std::vector<D> delta;
  for (int k = offset; k < offset + detail::tangent_dim(x); ++k)
    delta.push_back(k >= 0 && k < D::kSize ? D::variable(0, k) : D(0));
  return Manifold<detail::Rebind<T, D>>::oplus(Manifold<T>::template cast<D>(x), delta.data());
}

template <class T>
void expect_equal(const detail::Rebind<T, D>& actual, const detail::Rebind<T, D>& expected) {
  std::vector<D> a, b;
  append(actual, a);
  append(expected, b);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_NEAR(a[i].value, b[i].value, 1e-15);
    for (std::size_t k = 0; k < D::kSize; ++k) EXPECT_NEAR(a[i].derivative[k], b[i].derivative[k], 1e-15);
  }
}

/// Lifts x, and then `other` into the result, with all offsets: δ begins or ends within the variables, lies
/// between them, or has none.
template <class T>
void expect_derivatives_of_oplus(const T& x, const T& other) {
  for (int offset = -10; offset <= 10; ++offset) {
    const detail::Seed<D> seed{offset};
    detail::Rebind<T, D> y = detail::lift(x, seed);
    expect_equal<T>(y, moved(x, offset));
    detail::lift_again(other, seed, y);
    expect_equal<T>(y, moved(other, offset));
  }
}

template <class T>
constexpr bool kLiftsItself = detail::LiftsItself<T, D>;

TEST(Lift, EqualsOplusOverDualNumbers) {
  Samples samples;
  const auto so3 = [&] { return SO3::from_rotation_vector(samples.vector<3>(2)); };
  const auto se2 = [&] { return SE2::from_vector(samples.vector<3>(3)); };
  const auto se3 = [&] { return SE3(samples.vector<3>(10), so3()); };
  const auto turned = [&] { return SO3RotationVector::from_rotation_vector(samples.vector<3>(2)); };
  expect_derivatives_of_oplus(2.0, -3.0);
  expect_derivatives_of_oplus(samples.vector<3>(10), samples.vector<3>(10));
  expect_derivatives_of_oplus(se2(), se2());
  expect_derivatives_of_oplus(so3(), so3());
  expect_derivatives_of_oplus(turned(), turned());
  expect_derivatives_of_oplus(se3(), se3());
  expect_derivatives_of_oplus(SE3RotationVector(samples.vector<3>(10), turned()),
                              SE3RotationVector(samples.vector<3>(10), turned()));
  expect_derivatives_of_oplus(Pair(se3(), samples.vector<2>(10)), Pair(se3(), samples.vector<2>(10)));
}

TEST(Lift, OfAProductMayHavePartsWithoutAShortcut) {
  Samples samples;
  static_assert(!kLiftsItself<S2>);
  const auto nested = [&] {
    return Nested(Product<SE2, double>(SE2::from_vector(samples.vector<3>(3)), samples.uniform(1, 2)),
                  S2(samples.vector<3>(1)), SO3::from_rotation_vector(samples.vector<3>(2)));
  };
  expect_derivatives_of_oplus(nested(), nested());
}

TEST(Lift, OfPosesAndVectorsNeedsNoOplus) {
  static_assert(kLiftsItself<double> && kLiftsItself<Vector<double, 3>> && kLiftsItself<SE2>);
  static_assert(kLiftsItself<SO3> && kLiftsItself<SO3RotationVector>);
  static_assert(kLiftsItself<SE3> && kLiftsItself<SE3RotationVector> && kLiftsItself<Pair>);
}

/// A pose whose steps are added in the frame of the world.
template <class S>
struct WorldStepPose : BasicSE3<S> {
  using BasicSE3<S>::BasicSE3;
  WorldStepPose(const BasicSE3<S>& pose) : BasicSE3<S>(pose) {}
};

}  // namespace

template <class S>
struct Manifold<WorldStepPose<S>> : Manifold<BasicSE3<S>> {
  template <class T>
  using Rebind = WorldStepPose<T>;
  template <class T>
  static WorldStepPose<T> cast(const WorldStepPose<S>& x) {
    return x.template cast<T>();
  }
  static WorldStepPose<S> oplus(const WorldStepPose<S>& x, const S* delta) {
    return Manifold<BasicSE3<S>>::oplus(BasicSE3<S>(), delta) * x;
  }
};

namespace {

TEST(Lift, IsNotInheritedByAManifoldWithAnotherStep) {
  using X = WorldStepPose<double>;
  static_assert(!kLiftsItself<X>);
  const X x = SE3(Vector3(1, 2, 3), SO3::from_rotation_vector(Vector3(0.1, 0.2, 0.3)));
  const auto y = detail::lift(x, detail::Seed<D>{});
  EXPECT_EQ(y.translation()[0].derivative[0], 1) << "along the x axis of the world";
  EXPECT_EQ(y.translation()[0].derivative[1], 0);
}

TEST(Lift, OfAnEstimateOfRunTimeSizeFollowsEachSize) {
  using X = Vector<double, kDynamic>;
  static_assert(!kLiftsItself<X> && !kLiftsItself<Product<SE3, X>>);
  const detail::Seed<D> seed{1};
  auto y = detail::lift(X(X::LinSpaced(2, 3, 4)), seed);
  ASSERT_EQ(y.size(), 2);
  detail::lift_again(X(X::LinSpaced(3, 5, 7)), seed, y);
  ASSERT_EQ(y.size(), 3);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(y[i].value, 5 + i);
    EXPECT_EQ(y[i].derivative, D::variable(0, 1 + i).derivative);
  }
}

}  // namespace
}  // namespace boxplus
