// SPDX-License-Identifier: BSD-3-Clause
// A line segment in the plane as a vertex, and how a pose sees it.
#pragma once

#include <string_view>

#include "boxplus/manifold/manifold.h"
#include "boxplus/types/pose_math.h"

namespace boxplus {

/// The two end points of a segment (meters). ⊞ adds. The tag in g2o files is VERTEX_SEGMENT2D.
template <class S>
struct BasicSegment2 {
  using Scalar = S;
  static constexpr std::string_view kName = "Segment2";
  Vector<S, 2> first = Vector<S, 2>(S(0), S(0)), second = Vector<S, 2>(S(1), S(0));
};

using Segment2 = BasicSegment2<double>;

template <class S>
struct Manifold<BasicSegment2<S>> {
  using Point = BasicSegment2<S>;
  template <class T>
  using Rebind = BasicSegment2<T>;
  static constexpr int kDim = 4;

  template <class D>
  static Rebind<detail::Promoted<S, D>> oplus(const Point& x, const D* delta) {
    using T = detail::Promoted<S, D>;
    return {Vector<T, 2>(x.first[0] + delta[0], x.first[1] + delta[1]),
            Vector<T, 2>(x.second[0] + delta[2], x.second[1] + delta[3])};
  }
  template <class D>
  static void ominus(const Point& y, const Point& x, D* delta) {
    for (int i = 0; i < 2; ++i) {
      delta[i] = y.first[i] - x.first[i];
      delta[2 + i] = y.second[i] - x.second[i];
    }
  }
  template <class T>
  static Rebind<T> cast(const Point& x) {
    return {Vector<T, 2>(T(x.first[0]), T(x.first[1])), Vector<T, 2>(T(x.second[0]), T(x.second[1]))};
  }
};

namespace detail {

/// The angle of the normal of a segment: that of its direction, turned by −90°.
template <class S>
S normal_angle(const Vector<S, 2>& first, const Vector<S, 2>& second) {
  using std::atan2;
  return atan2(S(first[0] - second[0]), S(second[1] - first[1]));
}

}  // namespace detail

/// z measures both end points of the segment s in the frame of the pose X (meters). Error:
/// (X⁻¹ s₁ − z₁, X⁻¹ s₂ − z₂). Vertices: X, s. The tag in g2o files is EDGE_SE2_SEGMENT2D.
struct SegmentObservation2 {
  static constexpr std::string_view kName = "SegmentObservation2";
  Vector<double, 4> measurement;

  explicit SegmentObservation2(const Vector<double, 4>& z) : measurement(z) {}

  template <class S>
  Vector<S, 4> error(const BasicSE2<S>& pose, const BasicSegment2<S>& segment) const {
    const Vector<S, 2> first = pose.inverse_times(segment.first), second = pose.inverse_times(segment.second);
    return Vector<S, 4>(first[0] - measurement[0], first[1] - measurement[1], second[0] - measurement[2],
                        second[1] - measurement[3]);
  }
};

/// z = (θ, ρ) measures the line through the segment s in the frame of the pose X: the angle of its normal n
/// (the direction from s₁ to s₂, turned by −90°), and its signed distance from the origin (meters). Error:
/// (wrap(∠n − θ), n·(s₁ + s₂)/2 − ρ), with the segment in the frame of the pose. Vertices: X, s. The tag in
/// g2o files is EDGE_SE2_SEGMENT2D_LINE.
struct SegmentLineObservation2 {
  static constexpr std::string_view kName = "SegmentLineObservation2";
  Vector2 measurement;

  explicit SegmentLineObservation2(const Vector2& z) : measurement(z) {}

  template <class S>
  Vector<S, 2> error(const BasicSE2<S>& pose, const BasicSegment2<S>& segment) const {
    using std::cos;
    using std::sin;
    const Vector<S, 2> first = pose.inverse_times(segment.first), second = pose.inverse_times(segment.second);
    const S angle = detail::normal_angle(first, second);
    const S distance = 0.5 * (cos(angle) * (first[0] + second[0]) + sin(angle) * (first[1] + second[1]));
    return Vector<S, 2>(detail::normalize_angle(S(angle - measurement[0])), distance - measurement[1]);
  }
};

/// z = (x, y, θ) measures one end point of the segment s in the frame of the pose X, and the angle of the
/// normal of s, as in SegmentLineObservation2. Error: (X⁻¹ sₖ − (x, y), wrap(∠n − θ)). Vertices: X, s. The
/// tag in g2o files is EDGE_SE2_SEGMENT2D_POINTLINE.
struct SegmentEndObservation2 {
  static constexpr std::string_view kName = "SegmentEndObservation2";
  Vector3 measurement;
  bool is_second;  ///< whether k = 2

  SegmentEndObservation2(const Vector3& z, bool second) : measurement(z), is_second(second) {}

  template <class S>
  Vector<S, 3> error(const BasicSE2<S>& pose, const BasicSegment2<S>& segment) const {
    const Vector<S, 2> first = pose.inverse_times(segment.first), second = pose.inverse_times(segment.second);
    const Vector<S, 2>& end = is_second ? second : first;
    return Vector<S, 3>(end[0] - measurement[0], end[1] - measurement[1],
                        detail::normalize_angle(S(detail::normal_angle(first, second) - measurement[2])));
  }
};

}  // namespace boxplus
