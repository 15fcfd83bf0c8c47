// SPDX-License-Identifier: BSD-3-Clause
// An infinite line in space as a vertex, and how a pose sees it.
//
// The orthonormal representation (Bartoli and Sturm, "Structure-from-motion using lines: representation,
// triangulation, and bundle adjustment", CVIU 2005) of a line with moment w and direction d consists of
//   U = [w/|w|, d/|d|, (w × d)/|w × d|] in SO(3), and φ = atan2(|d|, |w|).
#pragma once

#include <string_view>

#include "boxplus/manifold/manifold.h"
#include "boxplus/types/pose_math.h"

namespace boxplus {

namespace detail {

/// a × b. (Eigen's cross() needs the larger header Eigen/Geometry.)
template <class S>
Vector<S, 3> cross_product(const Vector<S, 3>& a, const Vector<S, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace detail

/// A line in Plücker coordinates: w = p × d for each point p on the line, and the direction d, in any scale
/// with d ≠ 0. (w, d) and (−w, −d) are different: a line has a direction. If w has a part along d, this part
/// is ignored. ⊞ turns U by the vector part of a quaternion (half angles) from the right, adds to φ
/// (radians), and returns a line with |d| = 1; y ⊟ x is its inverse. If the line meets the origin, one of the
/// four directions of ⊞ does not move it to first order. The tag in g2o files is VERTEX_LINE3D.
template <class S>
struct BasicLine3 {
  using Scalar = S;
  static constexpr std::string_view kName = "Line3";
  Vector<S, 3> moment = Vector<S, 3>(S(0), S(0), S(0)), direction = Vector<S, 3>(S(1), S(0), S(0));

  /// The line through the point p.
  static BasicLine3 through(const Vector<S, 3>& p, const Vector<S, 3>& direction) {
    return {detail::cross_product(p, direction), direction};
  }
  /// The point of the line that is nearest to the origin.
  Vector<S, 3> nearest_point() const {
    return detail::cross_product(direction, moment) / direction.squaredNorm();
  }

  /// The line in the frame of the pose: (Rᵀ (w − t × d), Rᵀ d).
  template <class Chart>
  BasicLine3 seen_from(const BasicSE3<S, Chart>& pose) const {
    const Vector<S, 3> w = moment - detail::cross_product(pose.translation(), direction);
    const detail::Quaternion<S> q = pose.quaternion().conjugate();
    return {detail::rotate(q, w[0], w[1], w[2]), detail::rotate(q, direction[0], direction[1], direction[2])};
  }
};

using Line3 = BasicLine3<double>;

namespace detail {

/// U, and the sine and the cosine of φ.
template <class S>
struct OrthonormalLine {
  Matrix<S, 3, 3> U;
  S cosine, sine;
};

/// If a line comes this close to the origin (meters), squared, then w has no usable direction. The first
/// column of U is then a coordinate axis without its part along d.
inline constexpr double kMeetsOrigin = 1e-20;

/// A unit vector that is orthogonal to the unit vector d.
template <class S>
Vector<S, 3> orthogonal_to(const Vector<S, 3>& d) {
  using std::sqrt;
  int axis = 0;
  for (int i = 1; i < 3; ++i) {
    if (d[i] * d[i] < d[axis] * d[axis]) axis = i;
  }
  Vector<S, 3> u = -d[axis] * d;
  u[axis] = u[axis] + 1.0;
  return u / S(sqrt(u.squaredNorm()));
}

template <class S>
OrthonormalLine<S> orthonormal(const BasicLine3<S>& line) {
  using std::sqrt;
  const S length = sqrt(line.direction.squaredNorm());
  const Vector<S, 3> d = line.direction / length, w = line.moment / length;
  const Vector<S, 3> across = w - w.dot(d) * d;  // for |d| = 1, as long as the distance from the origin
  const S distance2 = across.squaredNorm();
  const bool meets_origin = distance2 < S(kMeetsOrigin);
  const Vector<S, 3> u = meets_origin ? orthogonal_to(d) : Vector<S, 3>(across / S(sqrt(distance2)));
  const S distance = meets_origin ? S(across.dot(u)) : S(sqrt(distance2));
  OrthonormalLine<S> result;
  result.U << u, d, cross_product(u, d);
  result.sine = 1.0 / sqrt(S(1.0 + distance * distance));
  result.cosine = distance * result.sine;
  return result;
}

}  // namespace detail

template <class S>
struct Manifold<BasicLine3<S>> {
  using Point = BasicLine3<S>;
  template <class T>
  using Rebind = BasicLine3<T>;
  static constexpr int kDim = 4;

  template <class D>
  static Rebind<detail::Promoted<S, D>> oplus(const Point& x, const D* delta) {
    using std::cos;
    using std::sin;
    using T = detail::Promoted<S, D>;
    const detail::OrthonormalLine<S> line = detail::orthonormal(x);
    const Matrix<D, 3, 3> turn =
        detail::rotation_matrix(detail::QuaternionChart::exp(delta[0], delta[1], delta[2]));
    const D c = cos(delta[3]), s = sin(delta[3]);
    const T distance = (line.cosine * c - line.sine * s) / (line.sine * c + line.cosine * s);
    Rebind<T> moved;
    for (int i = 0; i < 3; ++i) {
      const auto turned = [&](int axis) -> T {
        return line.U(i, 0) * turn(0, axis) + line.U(i, 1) * turn(1, axis) + line.U(i, 2) * turn(2, axis);
      };
      moved.moment[i] = distance * turned(0);
      moved.direction[i] = turned(1);
    }
    return moved;
  }
  template <class D>
  static void ominus(const Point& y, const Point& x, D* delta) {
    using std::atan2;
    const detail::OrthonormalLine<S> from = detail::orthonormal(x), to = detail::orthonormal(y);
    const Matrix<S, 3, 3> turn = from.U.transpose() * to.U;
    const Vector<S, 3> log = detail::QuaternionChart::log(detail::quaternion_of(turn));
    for (int i = 0; i < 3; ++i) delta[i] = log[i];
    delta[3] = atan2(S(from.cosine * to.sine - from.sine * to.cosine),
                     S(from.cosine * to.cosine + from.sine * to.sine));
  }
  template <class T>
  static Rebind<T> cast(const Point& x) {
    return {x.moment.template cast<T>(), x.direction.template cast<T>()};
  }
};

/// z measures the line l in the frame of a sensor at P on the body, or in the frame of the pose X. Error: z ⊟
/// l′, where l′ is l as seen from the sensor. Vertices: X, l, P (the tag in g2o files is EDGE_SE3_LINE3D), or
/// X, l.
struct LineObservation3 {
  static constexpr std::string_view kName = "LineObservation3";
  Line3 measurement;

  explicit LineObservation3(const Line3& z) : measurement(z) {}

  template <class S, class Chart>
  Vector<S, 4> error(const BasicSE3<S, Chart>& pose, const BasicLine3<S>& line) const {
    return difference(line.seen_from(pose));
  }
  template <class S, class Chart>
  Vector<S, 4> error(const BasicSE3<S, Chart>& pose, const BasicLine3<S>& line,
                     const BasicSE3<S, Chart>& offset) const {
    return difference(line.seen_from(pose).seen_from(offset));
  }

 private:
  template <class S>
  Vector<S, 4> difference(const BasicLine3<S>& seen) const {
    Vector<S, 4> e;
    Manifold<BasicLine3<S>>::ominus(Manifold<Line3>::cast<S>(measurement), seen, e.data());
    return e;
  }
};

}  // namespace boxplus
