// SPDX-License-Identifier: BSD-3-Clause
// Automatic differentiation of a functor whose arguments are arrays of scalars.
#pragma once
#ifndef G2O_AUTODIFF_H
#define G2O_AUTODIFF_H

#include <array>
#include <cstddef>
#include <tuple>
#include <utility>

#include "g2o/autodiff/jet.h"

namespace g2o {
namespace ceres {
namespace internal {

/// Differentiates a functor that is called as functor(x₀, x₁, …, error). The array x_k has Dims[k] values,
/// and the array `error` has Rows values.
template <int Rows, int... Dims>
class AutoDiff {
 public:
  static constexpr int kColumns = (0 + ... + Dims);
  using JetType = Jet<double, kColumns>;
  static constexpr std::size_t kArguments = sizeof...(Dims);

  /// Computes error = f(x). If jacobians[k] is not null, also writes the derivatives with respect to x_k to
  /// jacobians[k], as a column-major Rows × Dims[k] matrix. Returns false if the functor returns false.
  template <typename Functor>
  static bool Differentiate(const Functor& functor, const double* const* parameters, double* error,
                            double** jacobians) {
    std::array<JetType, static_cast<std::size_t>(kColumns)> x;
    std::array<JetType, static_cast<std::size_t>(Rows)> result;
    std::size_t next = 0;
    for (std::size_t k = 0; k < kArguments; ++k) {
      for (int i = 0; i < kDims[k]; ++i, ++next) x[next] = JetType(parameters[k][i], static_cast<int>(next));
    }
    if (!call(functor, x.data(), result.data(), std::make_index_sequence<kArguments>())) return false;
    for (int row = 0; row < Rows; ++row) error[row] = result[static_cast<std::size_t>(row)].a;
    int column = 0;
    for (std::size_t k = 0; k < kArguments; ++k) {
      for (int i = 0; i < kDims[k]; ++i, ++column) {
        if (jacobians[k] == nullptr) continue;
        for (int row = 0; row < Rows; ++row)
          jacobians[k][i * Rows + row] = result[static_cast<std::size_t>(row)].v[column];
      }
    }
    return true;
  }

 private:
  static constexpr std::array<int, kArguments> kDims{{Dims...}};
  static constexpr int offset(std::size_t k) {
    int sum = 0;
    for (std::size_t i = 0; i < k; ++i) sum += kDims[i];
    return sum;
  }
  template <typename Functor, std::size_t... K>
  static bool call(const Functor& functor, const JetType* x, JetType* result, std::index_sequence<K...>) {
    return functor((x + offset(K))..., result);
  }
};

}  // namespace internal
}  // namespace ceres
}  // namespace g2o

#endif  // G2O_AUTODIFF_H
