// SPDX-License-Identifier: BSD-3-Clause
// Scalars of the manifold types: double, or a dual number over it.
#pragma once

#include <type_traits>
#include <utility>

namespace boxplus {

/// The scalar of an expression in A and B: a dual number beside a double gives the dual number.
template <class A, class B>
using Promoted = std::decay_t<decltype(std::declval<const A&>() * std::declval<const B&>())>;

/// The scalar that X is made of: X::Scalar, or X itself where it is a scalar.
template <class X>
struct ScalarOfType {
  using Type = X;
};
template <class X>
requires requires {
  typename X::Scalar;
} &&(!requires(const X& x) { x.derivative; }) struct ScalarOfType<X> {
  using Type = typename X::Scalar;
};
template <class X>
using ScalarOf = typename ScalarOfType<X>::Type;

/// Squared angle (rad²) below which the functions of it switch to their Taylor series. With the terms that
/// are kept, value and first derivatives stay exact to rounding on both sides.
inline constexpr double kSmallSquaredAngle = 1e-4;

}  // namespace boxplus
