// SPDX-License-Identifier: BSD-3-Clause
// Lets Eigen use dual numbers as scalars, as in Vector<Dual<double, 3>, 2>. Expressions may mix matrices of
// dual numbers with matrices of double.
//
// Eigen's blocked product cannot multiply duals by doubles if both matrices have a run-time size (a matrix
// times a vector works). Write A.lazyProduct(B) instead, or cast one of them.
#pragma once

#include "boxplus/autodiff/dual_number.h"
#include "boxplus/base/matrix.h"

namespace Eigen {

template <class S, int N>
struct NumTraits<boxplus::detail::Dual<S, N>> {
  using Real = boxplus::detail::Dual<S, N>;
  using NonInteger = Real;
  using Literal = Real;
  using Nested = Real;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 0,
    ReadCost = (N + 1) * NumTraits<S>::ReadCost,
    AddCost = (N + 1) * NumTraits<S>::AddCost,
    MulCost = (2 * N + 1) * NumTraits<S>::MulCost
  };
  static Real epsilon() { return Real(NumTraits<S>::epsilon()); }
  static Real dummy_precision() { return Real(NumTraits<S>::dummy_precision()); }
  static Real highest() { return Real(NumTraits<S>::highest()); }
  static Real lowest() { return Real(NumTraits<S>::lowest()); }
  static Real infinity() { return Real(NumTraits<S>::infinity()); }
  static Real quiet_NaN() { return Real(NumTraits<S>::quiet_NaN()); }
  static int digits10() { return NumTraits<S>::digits10(); }
};

template <class S, int N, class T, class Op>
requires boxplus::detail::LowerScalar<T, S>
struct ScalarBinaryOpTraits<boxplus::detail::Dual<S, N>, T, Op> {
  using ReturnType = boxplus::detail::Dual<S, N>;
};
template <class S, int N, class T, class Op>
requires boxplus::detail::LowerScalar<T, S>
struct ScalarBinaryOpTraits<T, boxplus::detail::Dual<S, N>, Op> {
  using ReturnType = boxplus::detail::Dual<S, N>;
};

}  // namespace Eigen
