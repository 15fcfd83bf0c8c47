// SPDX-License-Identifier: BSD-3-Clause
// The Cholesky factorization of one small block, column-major.
#pragma once

#include <cmath>
#include <type_traits>

namespace boxplus {

/// Calls f(n). If n is 1, 2 or 3, passes it as a compile-time constant, so that the compiler unrolls loops.
template <class F>
inline auto with_small_size(int n, F&& f) {
  switch (n) {
    case 1:
      return f(std::integral_constant<int, 1>{});
    case 2:
      return f(std::integral_constant<int, 2>{});
    case 3:
      return f(std::integral_constant<int, 3>{});
    default:
      return f(n);
  }
}

/// Factorizes A = LLᵀ in place, in the lower triangle. Stores the reciprocals of L's diagonal on the
/// diagonal. Returns n, or the column of the first pivot that shows that A is not numerically positive
/// definite.
template <class Size>
inline int small_cholesky(double* a, Size n) {
  for (int j = 0; j < n; ++j) {
    const double original = a[j + j * n];
    double pivot = original;
    for (int k = 0; k < j; ++k) pivot -= a[j + k * n] * a[j + k * n];
    if (!(pivot > 1e-14 * original) || !std::isfinite(pivot)) return j;
    const double reciprocal = 1 / std::sqrt(pivot);
    a[j + j * n] = reciprocal;
    for (int i = j + 1; i < n; ++i) {
      double sum = a[i + j * n];
      for (int k = 0; k < j; ++k) sum -= a[i + k * n] * a[j + k * n];
      a[i + j * n] = sum * reciprocal;
    }
  }
  return n;
}

/// x ← (LLᵀ)⁻¹ x; L is the result of small_cholesky().
template <class Size>
inline void small_solve(const double* l, Size n, double* x) {
  for (int i = 0; i < n; ++i) {
    double sum = x[i];
    for (int k = 0; k < i; ++k) sum -= l[i + k * n] * x[k];
    x[i] = sum * l[i + i * n];
  }
  for (int i = n - 1; i >= 0; --i) {
    double sum = x[i];
    for (int k = i + 1; k < n; ++k) sum -= l[k + i * n] * x[k];
    x[i] = sum * l[i + i * n];
  }
}

}  // namespace boxplus
