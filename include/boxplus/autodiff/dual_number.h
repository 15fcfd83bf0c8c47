// SPDX-License-Identifier: BSD-3-Clause
// Forward-mode dual numbers: a value and its derivatives in N directions. The scalar may itself be a dual.
//
// Arithmetic on duals applies the chain rule, so a function template evaluated on duals returns its value and
// its exact derivatives (Clifford 1873; Griewank & Walther, "Evaluating Derivatives", 2008, §3.1). Nested
// duals give higher derivatives: Dual<Dual<double, 1>, N>.
//
// Comparisons use only the value. Without an initializer, a dual is indeterminate, like a double; Dual{} is
// zero.
#pragma once

#include <array>
#include <compare>
#include <type_traits>

namespace boxplus::detail {

template <class S, int N>
struct Dual;

/// Whether a value of type T acts as a constant when it is combined with duals over S. True if T is an
/// arithmetic type, S itself, or a scalar type nested in S.
template <class T, class S>
struct IsLowerScalar : std::bool_constant<std::is_arithmetic_v<T> || std::is_same_v<T, S>> {};
template <class T, class S, int N>
struct IsLowerScalar<T, Dual<S, N>>
    : std::bool_constant<std::is_same_v<T, Dual<S, N>> || IsLowerScalar<T, S>::value> {};
template <class T, class S>
concept LowerScalar = IsLowerScalar<T, S>::value;

template <class S, int N>
struct Dual {
  static_assert(N > 0);
  using Scalar = S;
  static constexpr int kSize = N;

  std::array<S, N> derivative;
  S value;

  Dual() = default;
  /// A constant: all of its derivatives are zero.
  template <LowerScalar<S> T>
  constexpr Dual(const T& constant) : derivative{}, value(static_cast<S>(constant)) {}  // NOLINT: implicit
  constexpr Dual(const S& value_in, const std::array<S, N>& derivative_in)
      : derivative(derivative_in), value(value_in) {}

  /// The independent variable `index`: its derivative is 1 in the direction `index` and 0 in all other
  /// directions.
  static constexpr Dual variable(const S& value, int index) {
    Dual x(value);
    x.derivative[index] = S(1);
    return x;
  }

  constexpr Dual& operator+=(const Dual& b) { return *this = *this + b; }
  constexpr Dual& operator-=(const Dual& b) { return *this = *this - b; }
  constexpr Dual& operator*=(const Dual& b) { return *this = *this * b; }
  constexpr Dual& operator/=(const Dual& b) { return *this = *this / b; }
  template <LowerScalar<S> T>
  constexpr Dual& operator+=(const T& b) {
    value += b;
    return *this;
  }
  template <LowerScalar<S> T>
  constexpr Dual& operator-=(const T& b) {
    value -= b;
    return *this;
  }
  template <LowerScalar<S> T>
  constexpr Dual& operator*=(const T& b) {
    return *this = *this * b;
  }
  template <LowerScalar<S> T>
  constexpr Dual& operator/=(const T& b) {
    return *this = *this / b;
  }

  friend constexpr Dual operator+(const Dual& a) { return a; }
  friend constexpr Dual operator-(const Dual& a) {
    Dual r;
    r.value = -a.value;
    for (int i = 0; i < N; ++i) r.derivative[i] = -a.derivative[i];
    return r;
  }

  friend constexpr Dual operator+(const Dual& a, const Dual& b) {
    Dual r;
    r.value = a.value + b.value;
    for (int i = 0; i < N; ++i) r.derivative[i] = a.derivative[i] + b.derivative[i];
    return r;
  }
  friend constexpr Dual operator-(const Dual& a, const Dual& b) {
    Dual r;
    r.value = a.value - b.value;
    for (int i = 0; i < N; ++i) r.derivative[i] = a.derivative[i] - b.derivative[i];
    return r;
  }
  friend constexpr Dual operator*(const Dual& a, const Dual& b) {
    Dual r;
    r.value = a.value * b.value;
    for (int i = 0; i < N; ++i) r.derivative[i] = a.derivative[i] * b.value + a.value * b.derivative[i];
    return r;
  }
  friend constexpr Dual operator/(const Dual& a, const Dual& b) {
    const S inverse = S(1) / b.value;
    Dual r;
    r.value = a.value / b.value;
    for (int i = 0; i < N; ++i) r.derivative[i] = (a.derivative[i] - r.value * b.derivative[i]) * inverse;
    return r;
  }

  template <LowerScalar<S> T>
  friend constexpr Dual operator+(const Dual& a, const T& b) {
    return {a.value + b, a.derivative};
  }
  template <LowerScalar<S> T>
  friend constexpr Dual operator+(const T& a, const Dual& b) {
    return {a + b.value, b.derivative};
  }
  template <LowerScalar<S> T>
  friend constexpr Dual operator-(const Dual& a, const T& b) {
    return {a.value - b, a.derivative};
  }
  template <LowerScalar<S> T>
  friend constexpr Dual operator-(const T& a, const Dual& b) {
    Dual r;
    r.value = a - b.value;
    for (int i = 0; i < N; ++i) r.derivative[i] = -b.derivative[i];
    return r;
  }
  template <LowerScalar<S> T>
  friend constexpr Dual operator*(const Dual& a, const T& b) {
    Dual r;
    r.value = a.value * b;
    for (int i = 0; i < N; ++i) r.derivative[i] = a.derivative[i] * b;
    return r;
  }
  template <LowerScalar<S> T>
  friend constexpr Dual operator*(const T& a, const Dual& b) {
    return b * a;
  }
  template <LowerScalar<S> T>
  friend constexpr Dual operator/(const Dual& a, const T& b) {
    const S inverse = S(1) / S(b);
    Dual r;
    r.value = a.value / b;
    for (int i = 0; i < N; ++i) r.derivative[i] = a.derivative[i] * inverse;
    return r;
  }
  template <LowerScalar<S> T>
  friend constexpr Dual operator/(const T& a, const Dual& b) {
    const S inverse = S(1) / b.value;
    Dual r;
    r.value = a / b.value;
    const S slope = -r.value * inverse;
    for (int i = 0; i < N; ++i) r.derivative[i] = slope * b.derivative[i];
    return r;
  }

  friend constexpr bool operator==(const Dual& a, const Dual& b) { return a.value == b.value; }
  friend constexpr std::partial_ordering operator<=>(const Dual& a, const Dual& b) {
    return a.value <=> b.value;
  }
};

/// Whether T is a dual number.
template <class T>
inline constexpr bool kIsDual = false;
template <class S, int N>
inline constexpr bool kIsDual<Dual<S, N>> = true;

/// The innermost value, without derivatives.
template <class T>
requires std::is_arithmetic_v<T>
constexpr double scalar_value(T x) {
  return static_cast<double>(x);
}
template <class S, int N>
constexpr double scalar_value(const Dual<S, N>& x) {
  return scalar_value(x.value);
}

}  // namespace boxplus::detail
