// SPDX-License-Identifier: BSD-3-Clause
// A plane in space as a vertex, and what measures it.
#pragma once

#include <array>
#include <string_view>

#include "boxplus/manifold/manifold.h"
#include "boxplus/types/pose_math.h"
#include "boxplus/types/slam3d/direction_angles.h"

namespace boxplus {

/// The points p with n·p + d = 0, where n and d are the coefficients (n, d), in any scale with n ≠ 0. In what
/// follows, |n| = 1, and ρ = −d is the distance from the origin along n, in meters. (n, d) and (−n, −d) are
/// different: a plane has a front. ⊞ turns n by an azimuth and an elevation (radians) in the frame F(n) of
/// direction_angles.h, and adds to ρ. y ⊟ x consists of the angles of n_y in the frame F(n_x), and ρ_y − ρ_x.
/// The tag in g2o files is VERTEX_PLANE.
template <class S>
struct BasicPlane3 {
  using Scalar = S;
  static constexpr std::string_view kName = "Plane3";
  Vector<S, 4> coefficients = Vector<S, 4>(S(1), S(0), S(0), S(-1));
  /// The color in which programs draw the plane: red, green and blue in [0, 1]. No error depends on it.
  std::array<double, 3> color{0.2, 0.2, 0.2};

  /// The same plane with |n| = 1. If |n| is already 1 up to rounding, the coefficients do not change.
  BasicPlane3 unit() const {
    using std::sqrt;
    const Vector<S, 4>& c = coefficients;
    const S n2 = c[0] * c[0] + c[1] * c[1] + c[2] * c[2];
    if (n2 > S(1 - detail::kUnitNormTolerance) && n2 < S(1 + detail::kUnitNormTolerance)) return *this;
    const S f = 1.0 / sqrt(n2);
    return {Vector<S, 4>(c[0] * f, c[1] * f, c[2] * f, c[3] * f), color};
  }
  /// n, in the scale of the coefficients.
  Vector<S, 3> normal() const { return {coefficients[0], coefficients[1], coefficients[2]}; }

  /// The plane in the frame of the pose: (Rᵀ n, d + n·t).
  template <class Chart>
  BasicPlane3 seen_from(const BasicSE3<S, Chart>& pose) const {
    const Vector<S, 4>& c = coefficients;
    const Vector<S, 3> t = pose.translation();
    const Vector<S, 3> n = detail::rotate(pose.quaternion().conjugate(), c[0], c[1], c[2]);
    return {Vector<S, 4>(n[0], n[1], n[2], c[3] + (c[0] * t[0] + c[1] * t[1] + c[2] * t[2])), color};
  }
};

using Plane3 = BasicPlane3<double>;

template <class S>
struct Manifold<BasicPlane3<S>> {
  using Point = BasicPlane3<S>;
  template <class T>
  using Rebind = BasicPlane3<T>;
  static constexpr int kDim = 3;

  template <class D>
  static Rebind<detail::Promoted<S, D>> oplus(const Point& x, const D* delta) {
    using T = detail::Promoted<S, D>;
    const Point plane = x.unit();
    const Vector<T, 3> n = detail::turned_direction(plane.normal(), delta[0], delta[1]);
    return {Vector<T, 4>(n[0], n[1], n[2], plane.coefficients[3] - delta[2]), x.color};
  }
  template <class D>
  static void ominus(const Point& y, const Point& x, D* delta) {
    const Point from = x.unit(), to = y.unit();
    const Vector<S, 2> angles = detail::angles_between(from.normal(), to.normal());
    delta[0] = angles[0];
    delta[1] = angles[1];
    delta[2] = from.coefficients[3] - to.coefficients[3];
  }
  template <class T>
  static Rebind<T> cast(const Point& x) {
    return {x.coefficients.template cast<T>(), x.color};
  }
};

/// z measures the plane π in the frame of a sensor at P on the body, or in the frame of the pose X. Error:
/// the azimuth and the elevation of n_z in the frame F(n′), and ρ′ − ρ_z, where (n′, ρ′) is π as seen from
/// the sensor. Vertices: X, π, P (the tag in g2o files is EDGE_SE3_PLANE_CALIB), or X, π.
struct PlaneObservation3 {
  static constexpr std::string_view kName = "PlaneObservation3";
  Plane3 measurement;

  explicit PlaneObservation3(const Plane3& z) : measurement(z) {}

  template <class S, class Chart>
  Vector<S, 3> error(const BasicSE3<S, Chart>& pose, const BasicPlane3<S>& plane) const {
    return difference(plane.seen_from(pose));
  }
  template <class S, class Chart>
  Vector<S, 3> error(const BasicSE3<S, Chart>& pose, const BasicPlane3<S>& plane,
                     const BasicSE3<S, Chart>& offset) const {
    return difference(plane.seen_from(pose).seen_from(offset));
  }

 private:
  template <class S>
  Vector<S, 3> difference(const BasicPlane3<S>& seen) const {
    const BasicPlane3<S> plane = seen.unit();
    const Plane3 z = measurement.unit();
    const Vector<S, 2> angles =
        detail::angles_between(plane.normal(), Vector<S, 3>(z.normal().template cast<S>()));
    return {angles[0], angles[1], z.coefficients[3] - plane.coefficients[3]};
  }
};

/// z measures the difference of the coefficients of two planes, in the scale |n| = 1. Error: (n₂, d₂) − (n₁,
/// d₁) − z. The tag in g2o files is EDGE_PLANE. The error has four rows, but planes have three degrees of
/// freedom.
struct PlaneDifference3 {
  static constexpr std::string_view kName = "PlaneDifference3";
  Vector<double, 4> measurement;

  explicit PlaneDifference3(const Vector<double, 4>& z) : measurement(z) {}

  template <class S>
  Vector<S, 4> error(const BasicPlane3<S>& first, const BasicPlane3<S>& second) const {
    const Vector<S, 4> from = first.unit().coefficients, to = second.unit().coefficients;
    Vector<S, 4> e;
    for (int i = 0; i < 4; ++i) e[i] = to[i] - from[i] - measurement[i];
    return e;
  }
};

}  // namespace boxplus
