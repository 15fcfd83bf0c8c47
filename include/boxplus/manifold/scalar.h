// SPDX-License-Identifier: BSD-3-Clause
// Scalars of the manifold types: double, or a dual number over it.
#pragma once

#include <type_traits>
#include <utility>

namespace boxplus::detail {

/// The scalar of the product of an A and a B. If one of the types is a dual number and the other is double,
/// this is the dual number.
template <class A, class B>
using Promoted = std::decay_t<decltype(std::declval<const A&>() * std::declval<const B&>())>;

/// The scalar of X: X::Scalar, or X itself if it is a scalar.
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

/// Below this squared angle (rad²), functions of the angle use their Taylor series. The series have so many
/// terms that, below this limit, values and first derivatives are exact up to rounding.
inline constexpr double kSmallSquaredAngle = 1e-4;

}  // namespace boxplus::detail
