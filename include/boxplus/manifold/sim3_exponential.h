// SPDX-License-Identifier: BSD-3-Clause
// The 3×3 matrix W that couples translation with rotation and scale in the exponential of Sim(3).
//
// Exp(ω, υ, σ) = (R, s, t) with R = Exp(ω), s = e^σ and t = W υ (Strasdat, "Local Accuracy and Global
// Consistency for Efficient Visual SLAM", PhD thesis, 2012, §2.4), with
//     W = ∫₀¹ e^{σu} Exp(uω) du = C I + A [ω]× + B [ω]×².
// With θ = |ω|, z = σ + iθ and φ(z) = (e^z − 1)/z = Σ zⁿ/(n+1)! the coefficients are
//     C = φ(σ),   A = Im φ(z) / θ,   B = (φ(σ) − Re φ(z)) / θ²,
// which are entire functions of (σ, θ²). If |z| < 4, the code sums the series; the number of terms depends on
// |z|. The series needs no special case for small angles. If |z| ≥ 4, the code uses the closed form.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "boxplus/base/matrix.h"
#include "boxplus/manifold/scalar.h"

namespace boxplus::detail {

/// W = c I + a [ω]× + b [ω]×².
template <class S>
struct Sim3Coupling {
  S a, b, c;

  /// The number N of terms of the series, for |z|² = z2 < 16. N is so large that the remainder of a, b, c and
  /// of their derivatives, at most N³ |z|ᴺ⁻³ / (N + 1)!, is below 1e-17.
  static int series_terms(const S& z2) {
    if (z2 < S(1.0 / 256)) return 12;
    return z2 < S(1) ? 22 : kSeriesTerms;
  }

  /// Sums the series, by recurrences that do not divide by θ. Let zⁿ = pₙ + iθ qₙ and rₙ = (σⁿ − pₙ)/θ². Then
  /// pₙ₊₁ = σ pₙ − θ² qₙ, qₙ₊₁ = pₙ + σ qₙ, and rₙ₊₁ = σ rₙ + qₙ.
  static Sim3Coupling from_series(const S& sigma, const S& theta2) {
    S p(1), q(0), r(0), power(1);
    Sim3Coupling sum{S(0), S(0), S(1)};
    const int terms = series_terms(sigma * sigma + theta2);
    for (int n = 1; n < terms; ++n) {
      const double factor = kInverseFactorials[n];
      r = sigma * r + q;
      const S next_p = sigma * p - theta2 * q;
      q = p + sigma * q;
      p = next_p;
      power = power * sigma;
      sum.a = sum.a + factor * q;
      sum.b = sum.b + factor * r;
      sum.c = sum.c + factor * power;
    }
    return sum;
  }

  /// Computes the coefficients from the closed form of φ(z), for |z| ≥ 4. If θ² < 1/400, |σ| must be large,
  /// and a short series in θ² with the moments Iₙ = ∫₀¹ uⁿ e^{σu} du is used, to avoid a division by a small
  /// θ.
  static Sim3Coupling from_closed_form(const S& sigma, const S& theta2) {
    using std::cos;
    using std::exp;
    using std::expm1;
    using std::sin;
    using std::sqrt;
    const S scale = exp(sigma), norm2 = sigma * sigma + theta2;
    if (theta2 < S(1.0 / 400)) {
      S moment[9];
      moment[0] = expm1(sigma) / sigma;
      for (int n = 1; n < 9; ++n) moment[n] = (scale - double(n) * moment[n - 1]) / sigma;
      const auto series = [&](int first, double f0, double f1, double f2, double f3) -> S {
        const S high = f2 * moment[first + 4] - theta2 * f3 * moment[first + 6];
        return f0 * moment[first] - theta2 * (f1 * moment[first + 2] - theta2 * high);
      };
      return {series(1, 1, 1.0 / 6, 1.0 / 120, 1.0 / 5040),
              series(2, 1.0 / 2, 1.0 / 24, 1.0 / 720, 1.0 / 40320), moment[0]};
    }
    const S theta = sqrt(theta2);
    const S real = scale * cos(theta) - 1.0, imaginary = scale * sin(theta);  // e^z − 1
    const S c = sigma * sigma < S(1e-2) ? from_series(sigma, S(0)).c : S(expm1(sigma) / sigma);
    return {(imaginary * sigma - real * theta) / (norm2 * theta),
            (c - (real * sigma + imaginary * theta) / norm2) / theta2, c};
  }

  static Sim3Coupling of(const S& sigma, const S& theta2) {
    return sigma * sigma + theta2 < S(16) ? from_series(sigma, theta2) : from_closed_form(sigma, theta2);
  }

  /// The coefficients of W⁻¹. W acts as the factor c along ω, and as the complex number (c − bθ²) + iaθ on
  /// the plane perpendicular to ω.
  Sim3Coupling inverse(const S& theta2) const {
    const S p = c - b * theta2;
    const S determinant = p * p + a * a * theta2;
    return {-a / determinant, (a * a - p * b) / (c * determinant), S(1) / c};
  }

  /// W v.
  Vector<S, 3> apply(const Vector<S, 3>& omega, const Vector<S, 3>& v) const {
    const Vector<S, 3> across = cross(omega, v);
    return v * c + across * a + cross(omega, across) * b;
  }

 private:
  static constexpr int kSeriesTerms = 36;  // 4³⁶ / 37! < 1e-21
  /// 1 / (n + 1)!
  static constexpr std::array<double, kSeriesTerms> kInverseFactorials = [] {
    std::array<double, kSeriesTerms> result{1};
    for (std::size_t n = 1; n < result.size(); ++n) result[n] = result[n - 1] / static_cast<double>(n + 1);
    return result;
  }();

  static Vector<S, 3> cross(const Vector<S, 3>& x, const Vector<S, 3>& y) {
    return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
  }
};

}  // namespace boxplus::detail
