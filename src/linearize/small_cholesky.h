// SPDX-License-Identifier: BSD-3-Clause
// Cholesky of one small block, column-major.
#pragma once

#include <cmath>

namespace boxplus {

/// A = LLᵀ in place (lower triangle); false where A is not positive definite to working precision.
inline bool small_cholesky(double* a, int n) {
  for (int j = 0; j < n; ++j) {
    const double original = a[j + j * n];
    double pivot = original;
    for (int k = 0; k < j; ++k) pivot -= a[j + k * n] * a[j + k * n];
    if (!(pivot > 1e-14 * original) || !std::isfinite(pivot)) return false;
    const double root = std::sqrt(pivot);
    a[j + j * n] = root;
    for (int i = j + 1; i < n; ++i) {
      double sum = a[i + j * n];
      for (int k = 0; k < j; ++k) sum -= a[i + k * n] * a[j + k * n];
      a[i + j * n] = sum / root;
    }
  }
  return true;
}

/// x ← L⁻¹ x, elements `stride` apart.
inline void small_forward(const double* l, int n, double* x, int stride = 1) {
  for (int i = 0; i < n; ++i) {
    double sum = x[i * stride];
    for (int k = 0; k < i; ++k) sum -= l[i + k * n] * x[k * stride];
    x[i * stride] = sum / l[i + i * n];
  }
}

/// x ← L⁻ᵀ x.
inline void small_backward(const double* l, int n, double* x) {
  for (int i = n - 1; i >= 0; --i) {
    double sum = x[i];
    for (int k = i + 1; k < n; ++k) sum -= l[k + i * n] * x[k];
    x[i] = sum / l[i + i * n];
  }
}

}  // namespace boxplus
