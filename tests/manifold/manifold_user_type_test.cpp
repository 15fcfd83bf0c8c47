// SPDX-License-Identifier: BSD-3-Clause
// A type of another library becomes a manifold if a user specializes the trait Manifold for it. The type
// itself does not change.
#include <gtest/gtest.h>

#include <cmath>

#include "boxplus/manifold/product.h"
#include "boxplus/manifold/rn.h"
#include "boxplus/testing/check_manifold.h"

namespace vendor {

/// Latitude and longitude in degrees, altitude in feet.
struct Waypoint {
  float padding;
  double latitude, longitude, altitude;
};

/// A template over its scalar type.
template <class S>
struct Interval {
  S center, log_width;
};

}  // namespace vendor

template <>
struct boxplus::Manifold<vendor::Waypoint> {
  static constexpr int kDim = 3;
  static vendor::Waypoint oplus(const vendor::Waypoint& x, const double* delta) {
    return {x.padding, x.latitude + delta[0], x.longitude + delta[1], x.altitude + delta[2]};
  }
  static void ominus(const vendor::Waypoint& y, const vendor::Waypoint& x, double* delta) {
    delta[0] = y.latitude - x.latitude;
    delta[1] = y.longitude - x.longitude;
    delta[2] = y.altitude - x.altitude;
  }
};

template <class S>
struct boxplus::Manifold<vendor::Interval<S>> {
  static constexpr int kDim = 2;
  template <class T>
  using Rebind = vendor::Interval<T>;
  template <class T>
  static vendor::Interval<T> cast(const vendor::Interval<S>& x) {
    return {T(x.center), T(x.log_width)};
  }
  static vendor::Interval<S> oplus(const vendor::Interval<S>& x, const S* delta) {
    return {x.center + delta[0], x.log_width + delta[1]};
  }
  static void ominus(const vendor::Interval<S>& y, const vendor::Interval<S>& x, S* delta) {
    delta[0] = y.center - x.center;
    delta[1] = y.log_width - x.log_width;
  }
};

namespace boxplus {
namespace {

using D = detail::Dual<double, 1>;

TEST(UserTypes, BecomeManifoldsThroughTheTraitAlone) {
  static_assert(detail::ManifoldType<vendor::Waypoint>);
  static_assert(!detail::LiftableManifold<vendor::Waypoint, D>);
  static_assert(!detail::ManifoldType<std::string>);
  const ManifoldCheck check = check_manifold(vendor::Waypoint{0, 48, 8, 1000});
  EXPECT_TRUE(check) << check.message;
}

TEST(UserTypes, AreConvertedToDualNumbersIfTheTraitHasACast) {
  static_assert(detail::LiftableManifold<vendor::Interval<double>, D>);
  const ManifoldCheck check = check_manifold(vendor::Interval<double>{1, 2});
  EXPECT_TRUE(check) << check.message;
}

TEST(UserTypes, CanBePartsOfProducts) {
  const Product liftable(vendor::Interval<double>{1, 2}, 3.0);
  static_assert(detail::LiftableManifold<std::decay_t<decltype(liftable)>, D>);
  const Product plain(vendor::Waypoint{0, 48, 8, 1000}, 3.0);
  static_assert(detail::ManifoldType<std::decay_t<decltype(plain)>>);
  static_assert(!detail::LiftableManifold<std::decay_t<decltype(plain)>, D>);
  EXPECT_TRUE(check_manifold(liftable));
  EXPECT_TRUE(check_manifold(plain));
}

}  // namespace
}  // namespace boxplus
