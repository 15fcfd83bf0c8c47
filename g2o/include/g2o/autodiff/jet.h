// SPDX-License-Identifier: BSD-3-Clause
// Forward-mode dual numbers: a value and its derivatives in N directions. If a function template is called
// with Jets, it returns its value and its exact derivatives (Griewank & Walther, "Evaluating Derivatives",
// 2008, §3.1).
//
// Comparisons use only the values. If the slope of a function is infinite (sqrt at 0, log at 0), the
// derivative of the result is still zero in each direction in which the derivative of the argument is zero.
#pragma once
#ifndef G2O_JET_H
#define G2O_JET_H

// clang-format off: this header comes first, because it sets the alignment of Eigen
#include "g2o/config.h"
// clang-format on

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <ostream>
#include <type_traits>

namespace g2o {
namespace ceres {

template <typename T, int N>
struct Jet {
  enum { DIMENSION = N };
  using Scalar = T;
  /// Unaligned, so that an array of Jets needs no special alignment.
  using Derivative = Eigen::Matrix<T, N, 1, Eigen::DontAlign>;

  T a;           ///< value
  Derivative v;  ///< derivatives

  /// Zero.
  Jet() : a(0), v(Derivative::Zero()) {}
  /// A constant.
  Jet(const T& value) : a(value), v(Derivative::Zero()) {}  // NOLINT: lets constants convert to Jets
  template <typename U,
            typename = std::enable_if_t<std::is_arithmetic<U>::value && !std::is_same<U, T>::value>>
  Jet(U value) : Jet(static_cast<T>(value)) {}  // NOLINT: lets constants convert to Jets
  /// The independent variable k. Its derivative in direction k is one.
  Jet(const T& value, int k) : a(value), v(Derivative::Unit(k)) {}
  template <typename D>
  Jet(const T& value, const Eigen::DenseBase<D>& derivative) : a(value), v(derivative.derived()) {}

  Jet& operator+=(const Jet& y) { return *this = *this + y; }
  Jet& operator-=(const Jet& y) { return *this = *this - y; }
  Jet& operator*=(const Jet& y) { return *this = *this * y; }
  Jet& operator/=(const Jet& y) { return *this = *this / y; }
  Jet& operator+=(const T& s) { return *this = *this + s; }
  Jet& operator-=(const T& s) { return *this = *this - s; }
  Jet& operator*=(const T& s) { return *this = *this * s; }
  Jet& operator/=(const T& s) { return *this = *this / s; }

  friend Jet operator+(const Jet& f) { return f; }
  friend Jet operator-(const Jet& f) { return Jet(-f.a, -f.v); }
  friend Jet operator+(const Jet& f, const Jet& g) { return Jet(f.a + g.a, f.v + g.v); }
  friend Jet operator-(const Jet& f, const Jet& g) { return Jet(f.a - g.a, f.v - g.v); }
  friend Jet operator*(const Jet& f, const Jet& g) { return Jet(f.a * g.a, f.v * g.a + g.v * f.a); }
  friend Jet operator/(const Jet& f, const Jet& g) {
    const T inverse = T(1) / g.a, quotient = f.a * inverse;
    return Jet(quotient, (f.v - g.v * quotient) * inverse);
  }
  friend Jet operator+(const Jet& f, const T& s) { return Jet(f.a + s, f.v); }
  friend Jet operator+(const T& s, const Jet& f) { return Jet(s + f.a, f.v); }
  friend Jet operator-(const Jet& f, const T& s) { return Jet(f.a - s, f.v); }
  friend Jet operator-(const T& s, const Jet& f) { return Jet(s - f.a, -f.v); }
  friend Jet operator*(const Jet& f, const T& s) { return Jet(f.a * s, f.v * s); }
  friend Jet operator*(const T& s, const Jet& f) { return Jet(s * f.a, f.v * s); }
  friend Jet operator/(const Jet& f, const T& s) { return f * (T(1) / s); }
  friend Jet operator/(const T& s, const Jet& f) {
    const T inverse = T(1) / f.a;
    return Jet(s * inverse, f.v * (-s * inverse * inverse));
  }

  friend bool operator<(const Jet& f, const Jet& g) { return f.a < g.a; }
  friend bool operator>(const Jet& f, const Jet& g) { return f.a > g.a; }
  friend bool operator<=(const Jet& f, const Jet& g) { return f.a <= g.a; }
  friend bool operator>=(const Jet& f, const Jet& g) { return f.a >= g.a; }
  friend bool operator==(const Jet& f, const Jet& g) { return f.a == g.a; }
  friend bool operator!=(const Jet& f, const Jet& g) { return f.a != g.a; }

  friend std::ostream& operator<<(std::ostream& os, const Jet& f) {
    return os << '[' << f.a << " ; " << f.v.transpose() << ']';
  }
};

namespace internal {

/// Returns g(f), given the value and the slope of a function g at f.a. Treats 0 · ∞ as 0.
template <typename T, int N>
Jet<T, N> chain(const T& value, const T& slope, const Jet<T, N>& f) {
  using std::isfinite;
  if (isfinite(slope)) return Jet<T, N>(value, f.v * slope);
  return Jet<T, N>(value, (f.v.array() == T(0)).select(T(0), f.v * slope));
}

}  // namespace internal

// The functions of the standard library for doubles. Clients call, for example, `ceres::sin(x)` with doubles
// and with Jets.
using std::abs;
using std::acos;
using std::asin;
using std::atan;
using std::atan2;
using std::cbrt;
using std::ceil;
using std::cos;
using std::cosh;
using std::exp;
using std::exp2;
using std::fabs;
using std::floor;
using std::fmax;
using std::fmin;
using std::hypot;
using std::isfinite;
using std::isinf;
using std::isnan;
using std::isnormal;
using std::log;
using std::log2;
using std::pow;
using std::sin;
using std::sinh;
using std::sqrt;
using std::tan;
using std::tanh;

template <typename T, int N>
Jet<T, N> abs(const Jet<T, N>& f) {
  return f.a < T(0) ? -f : f;
}
template <typename T, int N>
Jet<T, N> fabs(const Jet<T, N>& f) {
  return abs(f);
}
template <typename T, int N>
Jet<T, N> sqrt(const Jet<T, N>& f) {
  const T root = sqrt(f.a);
  return internal::chain(root, T(T(0.5) / root), f);
}
template <typename T, int N>
Jet<T, N> cbrt(const Jet<T, N>& f) {
  const T root = cbrt(f.a);
  return internal::chain(root, T(T(1) / (T(3) * root * root)), f);
}
template <typename T, int N>
Jet<T, N> exp(const Jet<T, N>& f) {
  const T e = exp(f.a);
  return internal::chain(e, e, f);
}
template <typename T, int N>
Jet<T, N> exp2(const Jet<T, N>& f) {
  const T e = exp2(f.a);
  return internal::chain(e, T(e * log(T(2))), f);
}
template <typename T, int N>
Jet<T, N> log(const Jet<T, N>& f) {
  return internal::chain(T(log(f.a)), T(T(1) / f.a), f);
}
template <typename T, int N>
Jet<T, N> log2(const Jet<T, N>& f) {
  return internal::chain(T(log2(f.a)), T(T(1) / (f.a * log(T(2)))), f);
}
template <typename T, int N>
Jet<T, N> sin(const Jet<T, N>& f) {
  return internal::chain(T(sin(f.a)), T(cos(f.a)), f);
}
template <typename T, int N>
Jet<T, N> cos(const Jet<T, N>& f) {
  return internal::chain(T(cos(f.a)), T(-sin(f.a)), f);
}
template <typename T, int N>
Jet<T, N> tan(const Jet<T, N>& f) {
  const T t = tan(f.a);
  return internal::chain(t, T(T(1) + t * t), f);
}
template <typename T, int N>
Jet<T, N> asin(const Jet<T, N>& f) {
  return internal::chain(T(asin(f.a)), T(T(1) / sqrt(T(1) - f.a * f.a)), f);
}
template <typename T, int N>
Jet<T, N> acos(const Jet<T, N>& f) {
  return internal::chain(T(acos(f.a)), T(T(-1) / sqrt(T(1) - f.a * f.a)), f);
}
template <typename T, int N>
Jet<T, N> atan(const Jet<T, N>& f) {
  return internal::chain(T(atan(f.a)), T(T(1) / (T(1) + f.a * f.a)), f);
}
template <typename T, int N>
Jet<T, N> sinh(const Jet<T, N>& f) {
  return internal::chain(T(sinh(f.a)), T(cosh(f.a)), f);
}
template <typename T, int N>
Jet<T, N> cosh(const Jet<T, N>& f) {
  return internal::chain(T(cosh(f.a)), T(sinh(f.a)), f);
}
template <typename T, int N>
Jet<T, N> tanh(const Jet<T, N>& f) {
  const T t = tanh(f.a);
  return internal::chain(t, T(T(1) - t * t), f);
}
template <typename T, int N>
Jet<T, N> atan2(const Jet<T, N>& y, const Jet<T, N>& x) {
  const T inverse = T(1) / (x.a * x.a + y.a * y.a);
  return Jet<T, N>(atan2(y.a, x.a), y.v * (x.a * inverse) - x.v * (y.a * inverse));
}
/// The derivative does not exist at the origin. There, this function returns the derivative zero.
template <typename T, int N>
Jet<T, N> hypot(const Jet<T, N>& x, const Jet<T, N>& y) {
  const T length = hypot(x.a, y.a);
  if (length == T(0)) return Jet<T, N>(length);
  return Jet<T, N>(length, x.v * (x.a / length) + y.v * (y.a / length));
}

template <typename T, int N>
Jet<T, N> pow(const Jet<T, N>& f, const std::common_type_t<T>& exponent) {
  if (exponent == T(0)) return Jet<T, N>(T(1));
  return internal::chain(T(pow(f.a, exponent)), T(exponent * pow(f.a, exponent - T(1))), f);
}
template <typename T, int N>
Jet<T, N> pow(const std::common_type_t<T>& base, const Jet<T, N>& f) {
  const T power = pow(base, f.a);
  return internal::chain(power, base == T(0) ? T(0) : T(power * log(base)), f);
}
template <typename T, int N>
Jet<T, N> pow(const Jet<T, N>& f, const Jet<T, N>& g) {
  return Jet<T, N>(pow(f.a, g.a), pow(f, g.a).v + pow(f.a, g).v);
}

template <typename T, int N>
Jet<T, N> fmin(const Jet<T, N>& f, const Jet<T, N>& g) {
  return g.a < f.a ? g : f;
}
template <typename T, int N>
Jet<T, N> fmax(const Jet<T, N>& f, const Jet<T, N>& g) {
  return f.a < g.a ? g : f;
}
template <typename T, int N>
Jet<T, N> floor(const Jet<T, N>& f) {
  return Jet<T, N>(floor(f.a));
}
template <typename T, int N>
Jet<T, N> ceil(const Jet<T, N>& f) {
  return Jet<T, N>(ceil(f.a));
}

/// Returns true if the value and all derivatives are finite.
template <typename T, int N>
bool isfinite(const Jet<T, N>& f) {
  return isfinite(f.a) && f.v.allFinite();
}
template <typename T, int N>
bool isnan(const Jet<T, N>& f) {
  return isnan(f.a) || f.v.hasNaN();
}
template <typename T, int N>
bool isinf(const Jet<T, N>& f) {
  bool infinite = isinf(f.a);
  for (int i = 0; i < N; ++i) infinite = infinite || isinf(f.v[i]);
  return infinite;
}
template <typename T, int N>
bool isnormal(const Jet<T, N>& f) {
  bool normal = isnormal(f.a);
  for (int i = 0; i < N; ++i) normal = normal && (f.v[i] == T(0) || isnormal(f.v[i]));
  return normal;
}
template <typename T, int N>
bool IsFinite(const Jet<T, N>& f) {
  return isfinite(f);
}
template <typename T, int N>
bool IsNaN(const Jet<T, N>& f) {
  return isnan(f);
}
template <typename T, int N>
bool IsInfinite(const Jet<T, N>& f) {
  return isinf(f);
}
template <typename T, int N>
bool IsNormal(const Jet<T, N>& f) {
  return isnormal(f);
}

// The functions that Eigen's algorithms need for a scalar type.
template <typename T, int N>
const Jet<T, N>& ei_conj(const Jet<T, N>& x) {
  return x;
}
template <typename T, int N>
const Jet<T, N>& ei_real(const Jet<T, N>& x) {
  return x;
}
template <typename T, int N>
Jet<T, N> ei_imag(const Jet<T, N>&) {
  return Jet<T, N>(T(0));
}
template <typename T, int N>
Jet<T, N> ei_abs(const Jet<T, N>& x) {
  return abs(x);
}

}  // namespace ceres
}  // namespace g2o

namespace Eigen {

template <typename T, int N>
struct NumTraits<g2o::ceres::Jet<T, N>> {
  using Real = g2o::ceres::Jet<T, N>;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = Real;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 1,
    AddCost = 1 + N,
    MulCost = 3 + 2 * N,
    HasFloatingPoint = 1
  };
  static Real epsilon() { return Real(std::numeric_limits<T>::epsilon()); }
  static Real dummy_precision() { return Real(NumTraits<T>::dummy_precision()); }
  static Real highest() { return Real(std::numeric_limits<T>::max()); }
  static Real lowest() { return Real(std::numeric_limits<T>::lowest()); }
  static Real infinity() { return Real(std::numeric_limits<T>::infinity()); }
  static Real quiet_NaN() { return Real(std::numeric_limits<T>::quiet_NaN()); }
  static int digits10() { return NumTraits<T>::digits10(); }
};

// Lets Eigen multiply matrices of Jets by matrices of plain scalars.
template <typename BinaryOp, typename T, int N>
struct ScalarBinaryOpTraits<g2o::ceres::Jet<T, N>, T, BinaryOp> {
  using ReturnType = g2o::ceres::Jet<T, N>;
};
template <typename BinaryOp, typename T, int N>
struct ScalarBinaryOpTraits<T, g2o::ceres::Jet<T, N>, BinaryOp> {
  using ReturnType = g2o::ceres::Jet<T, N>;
};

}  // namespace Eigen

namespace std {

template <typename T, int N>
struct numeric_limits<g2o::ceres::Jet<T, N>> : numeric_limits<T> {};

}  // namespace std

#endif  // G2O_JET_H
