// SPDX-License-Identifier: BSD-3-Clause
// A scalar type for formulas that are templates: one LaneNumber holds the values of several edges.
#pragma once

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
  friend auto operator>=(LaneNumber a, LaneNumber b) { return a.lanes >= b.lanes; }
};

/// In each lane, a if the comparison holds, otherwise b.
template <class Mask>
inline LaneNumber choose(Mask mask, LaneNumber a, LaneNumber b) {
  return LaneNumber::of(mask ? a.lanes : b.lanes);
}

}  // namespace boxplus::dense::BOXPLUS_ISA
