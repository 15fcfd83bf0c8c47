// SPDX-License-Identifier: BSD-3-Clause
// Operations on poses and points, in the plane and in space. Several edge types use them.
#pragma once

#include "boxplus/graph/manifold_frames.h"
#include "boxplus/manifold/same_size.h"
#include "boxplus/manifold/scalar.h"

namespace boxplus::detail {

/// T has a rotation and a translation.
template <class T>
inline constexpr bool kIsPose = requires(const T& x) {
  x.rotation();
  x.translation();
};

/// b relative to a: a⁻¹ b for poses and rotations, b − a for vectors. Throws InvalidArgument if their sizes
/// differ.
template <class X>
X motion_between(const X& a, const X& b) {
  require_same_size(a, "the first vertex", b);
  if constexpr (requires { a.inverse_times(b); }) {
    return a.inverse_times(b);
  } else if constexpr (requires { a - b; }) {
    return b - a;
  } else {
    return a.inverse() * b;
  }
}

/// e = x ⊟ z over the scalar of x: vec(z⁻¹ x) for poses, x − z for vectors. Throws InvalidArgument if their
/// sizes differ.
template <class X, class T>
auto difference(const X& x, const T& z) {
  require_same_size(z, "the measurement", x);
  using S = ScalarOf<X>;
  Vector<S, Manifold<T>::kDim> e(boxplus::detail::tangent_dim(x));
  Manifold<X>::ominus(x, Manifold<T>::template cast<S>(z), e.data());
  return e;
}

/// The position of a pose or point.
template <class X>
auto position(const X& x) {
  if constexpr (requires { x.translation(); }) {
    return x.translation();
  } else {
    return x;
  }
}

/// The relation T_to = T_from · motion. The first rows of its error are in meters, the last rows are angles.
/// Vector parts of quaternions are half angles.
template <class T>
RelativeFrame relative_pose(int from, int to, const T& motion) {
  RelativeFrame result{from, to, FrameTrait<T>::get(motion)};
  const int d = result.motion.dimension;
  result.translation_rows = d;
  if (result.motion.has_rotation) {
    result.rotation_row = d;
    result.rotation_rows = Manifold<T>::kDim - d;
    result.rotation_unit = std::is_same_v<T, SE3> ? 0.5 : 1;
  }
  return result;
}

}  // namespace boxplus::detail
