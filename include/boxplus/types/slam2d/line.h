// SPDX-License-Identifier: BSD-3-Clause
// An infinite line in the plane as a vertex, and what measures it.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "boxplus/manifold/manifold.h"
#include "boxplus/types/pose_math.h"

namespace boxplus {

/// The points p with n·p = ρ, where n = (cos θ, sin θ). θ is in radians, ρ in meters. ⊞ adds and wraps θ. The
/// tag in g2o files is VERTEX_LINE2D.
template <class S>
struct BasicLine2 {
  using Scalar = S;
  static constexpr std::string_view kName = "Line2";
  S angle = S(0), distance = S(0);
  /// The ids of two points between which programs draw the line; −1 if there is none. No error depends on
  /// them.
  std::array<std::int64_t, 2> ends{-1, -1};
};

using Line2 = BasicLine2<double>;

template <class S>
struct Manifold<BasicLine2<S>> {
  using Point = BasicLine2<S>;
  template <class T>
  using Rebind = BasicLine2<T>;
  static constexpr int kDim = 2;

  template <class D>
  static Rebind<detail::Promoted<S, D>> oplus(const Point& x, const D* delta) {
    using T = detail::Promoted<S, D>;
    return {detail::normalize_angle(T(x.angle + delta[0])), T(x.distance + delta[1]), x.ends};
  }
  template <class D>
  static void ominus(const Point& y, const Point& x, D* delta) {
    delta[0] = detail::normalize_angle(D(y.angle - x.angle));
    delta[1] = y.distance - x.distance;
  }
  template <class T>
  static Rebind<T> cast(const Point& x) {
    return {T(x.angle), T(x.distance), x.ends};
  }
};

/// z = (θ, ρ) measures the line l in the frame of the pose X. Error: (wrap(θ′ − θ), ρ′ − ρ), where (θ′, ρ′)
/// is l in this frame. Vertices: X, l. The tag in g2o files is EDGE_SE2_LINE2D.
struct LineObservation2 {
  static constexpr std::string_view kName = "LineObservation2";
  Vector2 measurement;

  explicit LineObservation2(const Vector2& z) : measurement(z) {}

  template <class S>
  Vector<S, 2> error(const BasicSE2<S>& pose, const BasicLine2<S>& line) const {
    using std::cos;
    using std::sin;
    const S distance = line.distance - (cos(line.angle) * pose.x() + sin(line.angle) * pose.y());
    return Vector<S, 2>(detail::normalize_angle(S(line.angle - pose.theta() - measurement[0])),
                        distance - measurement[1]);
  }
};

/// z = (θ, ρ) measures the difference of two lines. Error: (wrap(θ₂ − θ₁ − θ), ρ₂ − ρ₁ − ρ). The tag in g2o
/// files is EDGE_LINE2D.
struct LineDifference2 {
  static constexpr std::string_view kName = "LineDifference2";
  Vector2 measurement;

  explicit LineDifference2(const Vector2& z) : measurement(z) {}

  template <class S>
  Vector<S, 2> error(const BasicLine2<S>& first, const BasicLine2<S>& second) const {
    return Vector<S, 2>(detail::normalize_angle(S(second.angle - first.angle - measurement[0])),
                        second.distance - first.distance - measurement[1]);
  }
};

/// z measures the signed distance of the point p from the line l (meters), along the normal of l. Error:
/// n·p − ρ − z. Vertices: l, p. The tag in g2o files is EDGE_LINE2D_POINTXY.
struct PointToLine2 {
  static constexpr std::string_view kName = "PointToLine2";
  double measurement;

  explicit PointToLine2(double z) : measurement(z) {}

  template <class S, class Point>
  S error(const BasicLine2<S>& line, const Point& point) const {
    using std::cos;
    using std::sin;
    return cos(line.angle) * point[0] + sin(line.angle) * point[1] - line.distance - measurement;
  }
};

}  // namespace boxplus
