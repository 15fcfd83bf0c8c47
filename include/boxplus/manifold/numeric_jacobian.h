// SPDX-License-Identifier: BSD-3-Clause
// Numeric Jacobians through ⊞.
#pragma once

#include <algorithm>
#include <type_traits>
#include <vector>

#include "boxplus/autodiff/numeric.h"
#include "boxplus/manifold/manifold.h"

namespace boxplus::detail {

/// J ← the Jacobian of f(x ⊞ δ) at δ = 0. f returns a column vector or a scalar. J has one row per value of
/// f, and one column per tangent dimension of x. Returns the largest estimated error of an entry.
template <ManifoldType T, class F, class Jacobian>
double numeric_jacobian(const F& f, const T& x, Jacobian&& J, const NumericOptions& options = {}) {
  const int rows = static_cast<int>(J.rows());
  const int columns = tangent_dim(x);
  std::vector<double> delta(columns, 0.0), derivative(rows);
  NumericDerivative differentiate(options);
  double worst = 0;
  for (int k = 0; k < columns; ++k) {
    const auto along_k = [&](double h, double* values) {
      delta[k] = h;
      const auto& e = f(T(Manifold<T>::oplus(x, delta.data())));
      if constexpr (std::is_arithmetic_v<std::decay_t<decltype(e)>>) {
        values[0] = e;
      } else {
        for (int i = 0; i < rows; ++i) values[i] = e[i];
      }
    };
    worst = std::max(worst, differentiate(along_k, rows, derivative.data()));
    delta[k] = 0;
    for (int i = 0; i < rows; ++i) J(i, k) = derivative[i];
  }
  return worst;
}

}  // namespace boxplus::detail
