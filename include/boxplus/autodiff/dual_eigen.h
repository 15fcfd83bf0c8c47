// SPDX-License-Identifier: BSD-3-Clause
// Dual numbers as Eigen scalars: Vector<Dual<double, 3>, 2>, also mixed with matrices of double.
//
// Eigen's blocked product does not support mixed products of two run-time-size matrices (vectors work): write
// A.lazyProduct(B), or cast one side.
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
