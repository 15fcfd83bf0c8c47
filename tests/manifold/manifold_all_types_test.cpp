// SPDX-License-Identifier: BSD-3-Clause
// Properties of all manifold types. This file includes all headers of manifold/ and autodiff/. It should take
// little more time to compile than <Eigen/Core> alone (measured at -O2: 1.1 s versus 0.9 s of processor
// time), and must take less than 3 s.
#include <gtest/gtest.h>

#include <type_traits>

#include "boxplus/autodiff/dual.h"
#include "boxplus/autodiff/numeric.h"
#include "boxplus/manifold/angle.h"
#include "boxplus/manifold/manifold.h"
#include "boxplus/manifold/product.h"
#include "boxplus/manifold/rn.h"
#include "boxplus/manifold/s2.h"
#include "boxplus/manifold/se2.h"
#include "boxplus/manifold/se3.h"
#include "boxplus/manifold/sim3.h"
#include "boxplus/manifold/so2.h"
#include "boxplus/manifold/so3.h"

namespace boxplus {
namespace {

/// True if T can be copied by memcpy and has neither padding nor a larger alignment than its scalar.
template <class T, int kNumbers>
constexpr bool kIsPlain = std::is_trivially_copyable_v<T> && sizeof(T) == kNumbers * sizeof(double) &&
                          alignof(T) == alignof(double);

TEST(ManifoldTypes, HaveTheSameSizeAndAlignmentForAllCompilerFlags) {
  static_assert(kIsPlain<SO2, 1> && kIsPlain<SE2, 5> && kIsPlain<S2, 3> && kIsPlain<Sim3, 8>);
  static_assert(kIsPlain<SO3, 4> && kIsPlain<SO3RotationVector, 4>);
  static_assert(kIsPlain<SE3, 7> && kIsPlain<SE3RotationVector, 7>);
}

TEST(ManifoldTypes, CanAllBeConvertedToDualNumbers) {
  using D = detail::Dual<double, 12>;
  static_assert(detail::LiftableManifold<SO2, D> && detail::LiftableManifold<SE2, D> &&
                detail::LiftableManifold<S2, D>);
  static_assert(detail::LiftableManifold<SO3, D> && detail::LiftableManifold<SE3, D> &&
                detail::LiftableManifold<Sim3, D>);
  static_assert(detail::LiftableManifold<SO3RotationVector, D> &&
                detail::LiftableManifold<SE3RotationVector, D>);
  static_assert(detail::LiftableManifold<double, D> && detail::LiftableManifold<Vector<double, 3>, D>);
  static_assert(detail::LiftableManifold<Product<SE3, Vector<double, kDynamic>>, detail::Dual<D, 1>>);
}

}  // namespace
}  // namespace boxplus
