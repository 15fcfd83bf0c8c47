// SPDX-License-Identifier: BSD-3-Clause
// The functions of <cmath> on dual numbers. They are found by argument-dependent lookup: if you write `using
// std::sin; sin(x)`, in any namespace, x may be a dual number or a plain scalar.
//
// Some functions have an infinite slope at some point (sqrt at 0, asin at 1, log at 0). There, the derivative
// is zero in each direction in which the argument does not change. Therefore, the norm of a constant zero
// vector has the derivative 0, not NaN. At a kink, a function has a one-sided derivative: abs() at 0 has the
// derivative from the right, and fmin() and fmax() of equal arguments have the derivative of the first
// argument.
#pragma once

#include <cmath>

#include "boxplus/autodiff/dual_number.h"

namespace boxplus::detail {

// These declarations let unqualified calls in this namespace work for double and for duals.
using std::abs;
using std::cbrt;
using std::ceil;
using std::copysign;
using std::exp;
using std::exp2;
using std::expm1;
using std::fabs;
using std::floor;
using std::fmax;
using std::fmin;
using std::hypot;
using std::isfinite;
using std::isinf;
using std::isnan;
using std::log;
using std::log10;
using std::log1p;
using std::log2;
using std::pow;
using std::round;
using std::signbit;
using std::sqrt;
using std::trunc;

/// f(x), given its value f(x.value) and its slope f′(x.value).
template <class S, int N>
constexpr Dual<S, N> chain(const S& value, const S& slope, const Dual<S, N>& x) {
  Dual<S, N> r;
  r.value = value;
  for (int i = 0; i < N; ++i) r.derivative[i] = slope * x.derivative[i];
  return r;
}

/// f(x, y), given its value and its partial derivatives with respect to x and y.
template <class S, int N>
constexpr Dual<S, N> chain(const S& value, const S& slope_x, const Dual<S, N>& x, const S& slope_y,
                           const Dual<S, N>& y) {
  Dual<S, N> r;
  r.value = value;
  for (int i = 0; i < N; ++i) r.derivative[i] = slope_x * x.derivative[i] + slope_y * y.derivative[i];
  return r;
}

/// chain() for slopes that may be infinite: 0 · ∞ counts as 0.
template <class S, int N>
constexpr Dual<S, N> chain_singular(const S& value, const S& slope, const Dual<S, N>& x) {
  Dual<S, N> r;
  r.value = value;
  for (int i = 0; i < N; ++i) r.derivative[i] = x.derivative[i] == S(0) ? S(0) : slope * x.derivative[i];
  return r;
}

// --- roots and powers ---

template <class S, int N>
Dual<S, N> sqrt(const Dual<S, N>& x) {
  const S root = sqrt(x.value);
  const S slope = S(0.5) / root;
  return x.value == S(0) ? chain_singular(root, slope, x) : chain(root, slope, x);
}

template <class S, int N>
Dual<S, N> cbrt(const Dual<S, N>& x) {
  const S root = cbrt(x.value);
  return chain_singular(root, S(1) / (S(3) * root * root), x);
}

template <class S, int N>
Dual<S, N> hypot(const Dual<S, N>& x, const Dual<S, N>& y) {
  const S length = hypot(x.value, y.value);
  if (length == S(0)) return Dual<S, N>(length);  // 0 is a subgradient
  return chain(length, S(x.value / length), x, S(y.value / length), y);
}
template <class S, int N, LowerScalar<S> T>
Dual<S, N> hypot(const Dual<S, N>& x, const T& y) {
  return hypot(x, Dual<S, N>(y));
}
template <class S, int N, LowerScalar<S> T>
Dual<S, N> hypot(const T& x, const Dual<S, N>& y) {
  return hypot(Dual<S, N>(x), y);
}

/// xᵖ with a constant exponent.
template <class S, int N, LowerScalar<S> T>
Dual<S, N> pow(const Dual<S, N>& x, const T& p) {
  if (p == T(0)) return Dual<S, N>(1);
  return chain_singular(S(pow(x.value, p)), S(p * pow(x.value, p - T(1))), x);
}
template <class S, int N, LowerScalar<S> T>
Dual<S, N> pow(const T& base, const Dual<S, N>& y) {
  const S power = pow(S(base), y.value);
  return chain_singular(power, base == T(0) ? S(0) : S(log(S(base)) * power), y);
}
template <class S, int N>
Dual<S, N> pow(const Dual<S, N>& x, const Dual<S, N>& y) {
  const Dual<S, N> along_x = pow(x, y.value);
  const Dual<S, N> along_y = pow(x.value, y);
  Dual<S, N> r = along_x;
  for (int i = 0; i < N; ++i) r.derivative[i] += along_y.derivative[i];
  return r;
}

// --- exponentials and logarithms ---

template <class S, int N>
Dual<S, N> exp(const Dual<S, N>& x) {
  const S e = exp(x.value);
  return chain(e, e, x);
}

template <class S, int N>
Dual<S, N> exp2(const Dual<S, N>& x) {
  const S e = exp2(x.value);
  return chain(e, S(e * 0.69314718055994530942), x);
}

template <class S, int N>
Dual<S, N> expm1(const Dual<S, N>& x) {
  return chain(S(expm1(x.value)), S(exp(x.value)), x);
}

template <class S, int N>
Dual<S, N> log(const Dual<S, N>& x) {
  return chain_singular(S(log(x.value)), S(S(1) / x.value), x);
}

template <class S, int N>
Dual<S, N> log2(const Dual<S, N>& x) {
  return chain_singular(S(log2(x.value)), S(1.4426950408889634074 / x.value), x);
}

template <class S, int N>
Dual<S, N> log10(const Dual<S, N>& x) {
  return chain_singular(S(log10(x.value)), S(0.43429448190325182765 / x.value), x);
}

template <class S, int N>
Dual<S, N> log1p(const Dual<S, N>& x) {
  return chain_singular(S(log1p(x.value)), S(S(1) / (S(1) + x.value)), x);
}

// --- kinks and steps ---

template <class S, int N>
constexpr Dual<S, N> abs(const Dual<S, N>& x) {
  return x.value < S(0) ? -x : x;
}
template <class S, int N>
constexpr Dual<S, N> fabs(const Dual<S, N>& x) {
  return abs(x);
}

template <class S, int N>
constexpr Dual<S, N> fmin(const Dual<S, N>& x, const Dual<S, N>& y) {
  return y.value < x.value || x.value != x.value ? y : x;
}
template <class S, int N, LowerScalar<S> T>
constexpr Dual<S, N> fmin(const Dual<S, N>& x, const T& y) {
  return fmin(x, Dual<S, N>(y));
}
template <class S, int N, LowerScalar<S> T>
constexpr Dual<S, N> fmin(const T& x, const Dual<S, N>& y) {
  return fmin(Dual<S, N>(x), y);
}

template <class S, int N>
constexpr Dual<S, N> fmax(const Dual<S, N>& x, const Dual<S, N>& y) {
  return x.value < y.value || x.value != x.value ? y : x;
}
template <class S, int N, LowerScalar<S> T>
constexpr Dual<S, N> fmax(const Dual<S, N>& x, const T& y) {
  return fmax(x, Dual<S, N>(y));
}
template <class S, int N, LowerScalar<S> T>
constexpr Dual<S, N> fmax(const T& x, const Dual<S, N>& y) {
  return fmax(Dual<S, N>(x), y);
}

template <class S, int N>
Dual<S, N> floor(const Dual<S, N>& x) {
  return Dual<S, N>(floor(x.value));
}
template <class S, int N>
Dual<S, N> ceil(const Dual<S, N>& x) {
  return Dual<S, N>(ceil(x.value));
}
template <class S, int N>
Dual<S, N> trunc(const Dual<S, N>& x) {
  return Dual<S, N>(trunc(x.value));
}
template <class S, int N>
Dual<S, N> round(const Dual<S, N>& x) {
  return Dual<S, N>(round(x.value));
}

template <class S, int N>
Dual<S, N> copysign(const Dual<S, N>& x, const Dual<S, N>& sign) {
  return signbit(x) == signbit(sign) ? x : -x;
}
template <class S, int N, LowerScalar<S> T>
Dual<S, N> copysign(const Dual<S, N>& x, const T& sign) {
  return copysign(x, Dual<S, N>(sign));
}

template <class S, int N>
bool signbit(const Dual<S, N>& x) {
  return std::signbit(scalar_value(x));
}
template <class S, int N>
bool isnan(const Dual<S, N>& x) {
  return std::isnan(scalar_value(x));
}
template <class S, int N>
bool isinf(const Dual<S, N>& x) {
  return std::isinf(scalar_value(x));
}
/// Whether the value and all derivatives are finite.
template <class S, int N>
bool isfinite(const Dual<S, N>& x) {
  bool finite = isfinite(x.value);
  for (int i = 0; i < N; ++i) finite = finite && isfinite(x.derivative[i]);
  return finite;
}

}  // namespace boxplus::detail
