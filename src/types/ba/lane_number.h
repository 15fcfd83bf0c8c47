// SPDX-License-Identifier: BSD-3-Clause
// A scalar type for formulas that are templates: one LaneNumber holds the values of several edges.
#pragma once

#include <cmath>

#include "kernels/simd_pack.h"

namespace boxplus::dense::BOXPLUS_ISA {

struct LaneNumber {
  Pack lanes;

  LaneNumber() = default;
  LaneNumber(double value) : lanes(Pack{} + value) {}  // NOLINT(google-explicit-constructor): constants
  static LaneNumber of(Pack lanes) {
    LaneNumber number;
    number.lanes = lanes;
    return number;
  }

  friend LaneNumber operator+(LaneNumber a, LaneNumber b) { return of(a.lanes + b.lanes); }
  friend LaneNumber operator-(LaneNumber a, LaneNumber b) { return of(a.lanes - b.lanes); }
  friend LaneNumber operator*(LaneNumber a, LaneNumber b) { return of(a.lanes * b.lanes); }
  friend LaneNumber operator/(LaneNumber a, LaneNumber b) { return of(a.lanes / b.lanes); }
  friend LaneNumber operator-(LaneNumber a) { return of(-a.lanes); }
  friend auto operator>(LaneNumber a, LaneNumber b) { return a.lanes > b.lanes; }
  friend auto operator<(LaneNumber a, LaneNumber b) { return a.lanes < b.lanes; }
  friend auto operator>=(LaneNumber a, LaneNumber b) { return a.lanes >= b.lanes; }
  friend auto operator<=(LaneNumber a, LaneNumber b) { return a.lanes <= b.lanes; }
};

/// In each lane, a if the comparison holds, otherwise b.
template <class Mask>
inline LaneNumber choose(Mask mask, LaneNumber a, LaneNumber b) {
  return LaneNumber::of(mask ? a.lanes : b.lanes);
}

inline LaneNumber sqrt(LaneNumber a) {
#if defined(__AVX512F__)
  return LaneNumber::of(_mm512_maskz_sqrt_pd(0xff, a.lanes));
#elif defined(__AVX2__)
  return LaneNumber::of(_mm256_sqrt_pd(a.lanes));
#elif defined(BOXPLUS_NEON)
  return LaneNumber::of(vsqrtq_f64(a.lanes));
#else
  double x[kLanes];
  store(x, a.lanes);
  for (double& value : x) value = __builtin_sqrt(value);
  return LaneNumber::of(load(x));
#endif
}

/// Lane by lane. Equal neighbors share one call: the edges of a tile often share their camera.
inline LaneNumber tan(LaneNumber a) {
  double x[kLanes], y[kLanes];
  store(x, a.lanes);
  for (int l = 0; l < kLanes; ++l) y[l] = l > 0 && x[l] == x[l - 1] ? y[l - 1] : ::tan(x[l]);
  return LaneNumber::of(load(y));
}

/// The angle of the vector (x, y), with a relative error of a few roundings, for finite x and y.
///
/// With t = min/max of |x| and |y|, or (t − 1)/(t + 1) for t > tan(π/8), so that |t| ≤ tan(π/8), atan(t) is
/// t p(t²). The polynomial p interpolates atan(t)/t at Chebyshev nodes, with a relative error of 4e-17.
inline LaneNumber atan2(LaneNumber y, LaneNumber x) {
  constexpr double kQuarter = 0.78539816339744831, kTangent = 0.41421356237309503;  // π/4 and tan(π/8)
  constexpr double kPolynomial[] = {0.021135373157693246,  -0.043480522157164622, 0.056883492268090106,
                                    -0.066402339304294081, 0.076899534963068575,  -0.090907730748084142,
                                    0.11111106180455946,   -0.14285714180976467,  0.19999999998855111,
                                    -0.33333333333328441};
  const LaneNumber high = choose(y < 0.0, -y, y), wide = choose(x < 0.0, -x, x);
  const auto is_steep = high > wide;
  const LaneNumber small = choose(is_steep, wide, high), large = choose(is_steep, high, wide);
  const auto is_turned = small > kTangent * large;
  const LaneNumber divisor = choose(is_turned, small + large, large);
  const LaneNumber t = choose(is_turned, small - large, small) / choose(divisor <= 0.0, 1.0, divisor);
  const LaneNumber square = t * t;
  LaneNumber p = kPolynomial[0];
  for (int i = 1; i < 10; ++i) p = p * square + kPolynomial[i];
  LaneNumber angle = choose(is_turned, kQuarter, 0.0) + (t + t * (square * p));
  angle = choose(is_steep, 2.0 * kQuarter - angle, angle);
  angle = choose(x < 0.0, 4.0 * kQuarter - angle, angle);
  return choose(y < 0.0, -angle, angle);
}

}  // namespace boxplus::dense::BOXPLUS_ISA
