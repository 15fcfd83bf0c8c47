// SPDX-License-Identifier: BSD-3-Clause
// Circular and hyperbolic functions on dual numbers. The conventions of dual_functions.h apply.
#pragma once

#include "boxplus/autodiff/dual_functions.h"

namespace boxplus::detail {

using std::acos;
using std::acosh;
using std::asin;
using std::asinh;
using std::atan;
using std::atan2;
using std::atanh;
using std::cos;
using std::cosh;
using std::sin;
using std::sinh;
using std::tan;
using std::tanh;

template <class S, int N>
Dual<S, N> sin(const Dual<S, N>& x) {
  return chain(S(sin(x.value)), S(cos(x.value)), x);
}

template <class S, int N>
Dual<S, N> cos(const Dual<S, N>& x) {
  return chain(S(cos(x.value)), S(-sin(x.value)), x);
}

template <class S, int N>
Dual<S, N> tan(const Dual<S, N>& x) {
  const S t = tan(x.value);
  return chain(t, S(S(1) + t * t), x);
}

template <class S, int N>
Dual<S, N> asin(const Dual<S, N>& x) {
  return chain_singular(S(asin(x.value)), S(S(1) / sqrt((S(1) - x.value) * (S(1) + x.value))), x);
}

template <class S, int N>
Dual<S, N> acos(const Dual<S, N>& x) {
  return chain_singular(S(acos(x.value)), S(S(-1) / sqrt((S(1) - x.value) * (S(1) + x.value))), x);
}

template <class S, int N>
Dual<S, N> atan(const Dual<S, N>& x) {
  return chain(S(atan(x.value)), S(S(1) / (S(1) + x.value * x.value)), x);
}

/// The angle of the point (x, y). Its derivative at the origin does not exist and is NaN.
template <class S, int N>
Dual<S, N> atan2(const Dual<S, N>& y, const Dual<S, N>& x) {
  const S inverse = S(1) / (x.value * x.value + y.value * y.value);
  return chain(S(atan2(y.value, x.value)), S(x.value * inverse), y, S(-y.value * inverse), x);
}
template <class S, int N, LowerScalar<S> T>
Dual<S, N> atan2(const Dual<S, N>& y, const T& x) {
  return atan2(y, Dual<S, N>(x));
}
template <class S, int N, LowerScalar<S> T>
Dual<S, N> atan2(const T& y, const Dual<S, N>& x) {
  return atan2(Dual<S, N>(y), x);
}

template <class S, int N>
Dual<S, N> sinh(const Dual<S, N>& x) {
  return chain(S(sinh(x.value)), S(cosh(x.value)), x);
}

template <class S, int N>
Dual<S, N> cosh(const Dual<S, N>& x) {
  return chain(S(cosh(x.value)), S(sinh(x.value)), x);
}

template <class S, int N>
Dual<S, N> tanh(const Dual<S, N>& x) {
  const S t = tanh(x.value);
  return chain(t, S((S(1) - t) * (S(1) + t)), x);
}

template <class S, int N>
Dual<S, N> asinh(const Dual<S, N>& x) {
  return chain(S(asinh(x.value)), S(S(1) / sqrt(x.value * x.value + S(1))), x);
}

template <class S, int N>
Dual<S, N> acosh(const Dual<S, N>& x) {
  return chain_singular(S(acosh(x.value)), S(S(1) / sqrt((x.value - S(1)) * (x.value + S(1)))), x);
}

template <class S, int N>
Dual<S, N> atanh(const Dual<S, N>& x) {
  return chain_singular(S(atanh(x.value)), S(S(1) / ((S(1) - x.value) * (S(1) + x.value))), x);
}

}  // namespace boxplus::detail
