// SPDX-License-Identifier: BSD-3-Clause
// Lens distortion: a map of the normalized image to itself, with its derivatives.
//
// With u = (u, v) and r² = u² + v²:
//   d(u) = R(r²) u + tangential(u) + prism(u),   R = (1 + Σ n_i r^2i) / (1 + Σ m_i r^2i)
//   tangential (decentering): (2 p1 u v + p2 (r² + 2u²), 2 p2 u v + p1 (r² + 2v²))
//   thin prism:               (s1 r², s2 r²)
// These are the terms of Brown, "Decentering distortion of lenses" (1966), and of Weng, Cohen and Herniou,
// "Camera calibration with distortion models and accuracy evaluation" (1992). The other maps are at the end.
//
// The functions are generic in the scalar S: double, a dual number, or a pack of SIMD lanes. A pack needs the
// operators + − * /, comparisons, sqrt(), tan() and atan2(), a constructor from double, and
// choose(mask, S, S), all found by argument-dependent lookup. Matrices are column-major arrays.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "boxplus/autodiff/dual.h"

namespace boxplus::detail {

/// Whether a function shall compute derivatives: it gets a pointer to their place, or nullptr.
template <class J>
inline constexpr bool kWanted = !std::is_same_v<J, std::nullptr_t>;

/// a if the condition holds, otherwise b.
template <class S>
constexpr S choose(bool condition, const S& a, const S& b) {
  return condition ? a : b;
}

template <class S>
struct Inverse {
  S value, slope;
};

/// Below this absolute value, inverse() deviates from 1/x.
inline constexpr double kSmallDivisor = 1e-9;

/// 1/x and its derivative. Near 0, an odd polynomial joins both branches with a continuous derivative, so
/// that the result is finite for every finite x.
template <class S>
Inverse<S> inverse(const S& x) {
  constexpr double kScale = 1 / (kSmallDivisor * kSmallDivisor);
  const S square = x * x * kScale;
  const auto is_large = square >= 1.0;
  if constexpr (std::is_same_v<S, double>) {
    if (is_large) [[likely]] {
      const double exact = 1 / x;
      return {exact, -exact * exact};
    }
  }
  const S exact = 1.0 / choose(is_large, x, S(1.0));
  return {choose(is_large, exact, S(x * kScale * (2.0 - square))),
          choose(is_large, S(-exact * exact), S(kScale * (2.0 - 3.0 * square)))};
}

template <class S>
struct Root {
  S value, slope;
};

/// √x and its derivative. A negative x has the root −√−x. Where the root is below kSmallDivisor, an odd
/// polynomial joins both branches with a continuous derivative, so that the result is finite for every finite
/// x.
template <class S>
Root<S> root(const S& x) {
  using std::sqrt;
  constexpr double kScale = 1 / (kSmallDivisor * kSmallDivisor);
  const auto is_negative = x < 0.0;
  const S size = choose(is_negative, S(-x), x), scaled = size * kScale;
  const auto is_large = scaled >= 1.0;
  const S exact = sqrt(choose(is_large, size, S(1.0))), square = scaled * scaled;
  const S value = choose(is_large, exact, S(kSmallDivisor * scaled * (1.25 - 0.25 * square)));
  return {choose(is_negative, S(-value), value),
          choose(is_large, S(0.5 / exact), S((1.25 - 0.75 * square) / kSmallDivisor))};
}

template <class S>
struct Polynomial {
  S value, slope;
};

/// 1 + Σ k[Index_i] xⁱ for i = 1, 2, …
template <int... Index>
struct Terms {
  static constexpr int kCount = sizeof...(Index);
  static constexpr std::array<int, sizeof...(Index)> kIndex{Index...};

  /// Horner's scheme, for the value and for the derivative with respect to x.
  template <class S>
  static Polynomial<S> evaluate(const S& x, const S* k) {
    if constexpr (kCount == 0) {
      return {S(1.0), S(0.0)};
    } else {
      S value = k[kIndex[kCount - 1]], slope(0.0);
      for (int i = kCount - 2; i >= 0; --i) {
        slope = slope * x + value;
        value = value * x + k[kIndex[static_cast<std::size_t>(i)]];
      }
      slope = slope * x + value;
      return {S(value * x + 1.0), slope};
    }
  }

  /// The columns of ∂(R u)/∂k, given ∂R/∂(value of this polynomial).
  template <class S>
  static void derivatives(const S& x, const S& R_by_value, const S* u, S* J_k) {
    S power = R_by_value;
    for (const int column : kIndex) {
      power = power * x;
      J_k[2 * column] = power * u[0];
      J_k[2 * column + 1] = power * u[1];
    }
  }
};

/// Indices of coefficients in k: of the radial polynomials, of p1 (p2 follows), and of s1 (s2 follows).
template <class Numerator, class Denominator = Terms<>, int kTangential = -1, int kPrism = -1>
struct Distortion {
  static constexpr bool kIsRational = Denominator::kCount > 0;
  static constexpr int kSize =
      Numerator::kCount + Denominator::kCount + (kTangential < 0 ? 0 : 2) + (kPrism < 0 ? 0 : 2);

  /// d ← d(u), J_u ← ∂d/∂u (2 × 2), J_k ← ∂d/∂k (2 × kSize).
  template <class S, class J>
  static void apply(const S* u, const S* k, S* d, J J_u, J J_k) {
    const S x = u[0] * u[0] + u[1] * u[1];
    const Polynomial<S> numerator = Numerator::evaluate(x, k);
    S R = numerator.value, slope = numerator.slope;
    if constexpr (kIsRational) {
      const Polynomial<S> denominator = Denominator::evaluate(x, k);
      const Inverse<S> inverted = inverse(denominator.value);
      const S R_by_denominator = numerator.value * inverted.slope;
      R = numerator.value * inverted.value;
      slope = numerator.slope * inverted.value + R_by_denominator * denominator.slope;
      if constexpr (kWanted<J>) {
        Numerator::derivatives(x, inverted.value, u, J_k);
        Denominator::derivatives(x, R_by_denominator, u, J_k);
      }
    } else if constexpr (kWanted<J>) {
      Numerator::derivatives(x, S(1.0), u, J_k);
    }
    d[0] = R * u[0];
    d[1] = R * u[1];
    if constexpr (kWanted<J>) {
      const S twice = 2.0 * slope;
      J_u[0] = R + twice * u[0] * u[0];
      J_u[1] = J_u[2] = twice * u[0] * u[1];
      J_u[3] = R + twice * u[1] * u[1];
    }
    if constexpr (kTangential >= 0) add_tangential(u, x, k, d, J_u, J_k);
    if constexpr (kPrism >= 0) add_prism(u, x, k, d, J_u, J_k);
  }

  /// Whether the model describes the image at u: the denominator is positive.
  template <class S>
  static bool is_defined(const S* u, const S* k) {
    const S x = u[0] * u[0] + u[1] * u[1];
    return Denominator::evaluate(x, k).value > kSmallDivisor;
  }

 private:
  template <class S, class J>
  static void add_tangential(const S* u, const S& x, const S* k, S* d, J J_u, J J_k) {
    const S p1 = k[kTangential], p2 = k[kTangential + 1];
    const S mixed = 2.0 * u[0] * u[1], along_u = x + 2.0 * u[0] * u[0], along_v = x + 2.0 * u[1] * u[1];
    d[0] = d[0] + p1 * mixed + p2 * along_u;
    d[1] = d[1] + p2 * mixed + p1 * along_v;
    if constexpr (kWanted<J>) {
      const S both = 2.0 * (p1 * u[0] + p2 * u[1]);
      J_u[0] = J_u[0] + 2.0 * p1 * u[1] + 6.0 * p2 * u[0];
      J_u[1] = J_u[1] + both;
      J_u[2] = J_u[2] + both;
      J_u[3] = J_u[3] + 2.0 * p2 * u[0] + 6.0 * p1 * u[1];
      S* const column = J_k + 2 * kTangential;
      column[0] = column[3] = mixed;
      column[1] = along_v;
      column[2] = along_u;
    }
  }

  template <class S, class J>
  static void add_prism(const S* u, const S& x, const S* k, S* d, J J_u, J J_k) {
    for (int i = 0; i < 2; ++i) {
      const S s = k[kPrism + i];
      d[i] = d[i] + s * x;
      if constexpr (kWanted<J>) {
        J_u[i] = J_u[i] + 2.0 * s * u[0];
        J_u[2 + i] = J_u[2 + i] + 2.0 * s * u[1];
        J_k[2 * (kPrism + i) + i] = x;
        J_k[2 * (kPrism + i) + 1 - i] = S(0.0);
      }
    }
  }
};

/// Decentering and thin prism with the parameters p0, p1, s0, s1, s2, s3 of Engel et al., "Project Aria: a
/// new tool for egocentric multi-modal AI research" (2023):
///   d(u) = u + p r² + 2 (pᵀu) u + (s0 r² + s1 r⁴, s2 r² + s3 r⁴)
struct DecenteredPrism {
  static constexpr int kSize = 6;

  template <class S, class J>
  static void apply(const S* u, const S* k, S* d, J J_u, J J_k) {
    const S x = u[0] * u[0] + u[1] * u[1], twice = 2.0 * (k[0] * u[0] + k[1] * u[1]);
    for (int i = 0; i < 2; ++i) {
      const S p = k[i], s = k[2 + 2 * i], t = k[3 + 2 * i];
      d[i] = u[i] + p * x + twice * u[i] + (s + t * x) * x;
      if constexpr (kWanted<J>) {
        const S along_u = 2.0 * (p + s + 2.0 * t * x);
        for (int j = 0; j < 2; ++j) {
          J_u[2 * j + i] = along_u * u[j] + 2.0 * u[i] * k[j];
          J_k[2 * j + i] = 2.0 * u[i] * u[j];
        }
        J_u[3 * i] = J_u[3 * i] + twice + 1.0;
        J_k[3 * i] = J_k[3 * i] + x;
        for (int m = 2; m < kSize; ++m) J_k[2 * m + i] = S(0.0);
        J_k[2 * (2 + 2 * i) + i] = x;
        J_k[2 * (3 + 2 * i) + i] = x * x;
      }
    }
  }

  template <class S>
  static bool is_defined(const S* /*u*/, const S* /*k*/) {
    return true;
  }
};

/// Second after First, whose parameters come first.
template <class First, class Second>
struct Composition {
  static constexpr int kSize = First::kSize + Second::kSize;

  template <class S, class J>
  static void apply(const S* u, const S* k, S* d, J J_u, J J_k) {
    S v[2];
    if constexpr (!kWanted<J>) {
      First::apply(u, k, v, nullptr, nullptr);
      Second::apply(v, k + First::kSize, d, nullptr, nullptr);
    } else {
      S J_v[4];
      First::apply(u, k, v, J_u, J_k);
      Second::apply(v, k + First::kSize, d, static_cast<J>(J_v), J_k + 2 * First::kSize);
      multiply<2>(J_v, J_u);
      multiply<First::kSize>(J_v, J_k);
    }
  }

  template <class S>
  static bool is_defined(const S* u, const S* k) {
    S v[2];
    First::apply(u, k, v, nullptr, nullptr);
    return First::is_defined(u, k) && Second::is_defined(v, k + First::kSize);
  }

 private:
  /// B ← A B, where A is 2 × 2.
  template <int kColumns, class S>
  static void multiply(const S* A, S* B) {
    for (int m = 0; m < kColumns; ++m) {
      const S first = B[2 * m], second = B[2 * m + 1];
      B[2 * m] = A[0] * first + A[2] * second;
      B[2 * m + 1] = A[1] * first + A[3] * second;
    }
  }
};

}  // namespace boxplus::detail
