// SPDX-License-Identifier: BSD-3-Clause
// The parameters of a robot with two driven wheels, as a vertex.
#pragma once

#include <array>
#include <string_view>

#include "boxplus/base/matrix.h"
#include "boxplus/manifold/manifold.h"
#include "boxplus/manifold/scalar.h"

namespace boxplus {

/// Factors for the measured speeds of the left and right wheel, and the distance between the wheels (meters).
/// ⊞ adds. The tag in g2o files is VERTEX_ODOM_DIFFERENTIAL.
template <class S>
struct BasicDifferentialDrive {
  using Scalar = S;
  static constexpr std::string_view kName = "DifferentialDrive";
  S left_factor = S(1), right_factor = S(1), baseline = S(1);
};

using DifferentialDrive = BasicDifferentialDrive<double>;

template <class S>
struct Manifold<BasicDifferentialDrive<S>> {
  using Point = BasicDifferentialDrive<S>;
  template <class T>
  using Rebind = BasicDifferentialDrive<T>;
  static constexpr int kDim = 3;

  template <class D>
  static Rebind<detail::Promoted<S, D>> oplus(const Point& x, const D* delta) {
    return {x.left_factor + delta[0], x.right_factor + delta[1], x.baseline + delta[2]};
  }
  template <class D>
  static void ominus(const Point& y, const Point& x, D* delta) {
    delta[0] = y.left_factor - x.left_factor;
    delta[1] = y.right_factor - x.right_factor;
    delta[2] = y.baseline - x.baseline;
  }
  template <class T>
  static Rebind<T> cast(const Point& x) {
    return {T(x.left_factor), T(x.right_factor), T(x.baseline)};
  }
};

}  // namespace boxplus
