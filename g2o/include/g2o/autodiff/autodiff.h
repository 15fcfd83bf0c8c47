// SPDX-License-Identifier: BSD-3-Clause
// Automatic differentiation of a functor whose arguments are arrays of scalars.
#pragma once
#ifndef G2O_AUTODIFF_H
#define G2O_AUTODIFF_H

#if __cplusplus < 201703L
#pragma GCC system_header  // Otherwise, compilers warn about C++17 in this header.
#endif

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "g2o/autodiff/jet.h"

namespace g2o {
namespace ceres {

/// A number of rows that is known only at run time.
enum DimensionType { DYNAMIC = -1 };

namespace internal {

/// The arguments x₀, x₁, … of a functor as independent variables. The array x_k has Dims[k] values.
template <typename T, int... Dims>
class Variables {
 public:
  static constexpr int kColumns = (0 + ... + Dims);
  using JetType = Jet<T, kColumns>;
  static constexpr std::size_t kArguments = sizeof...(Dims);

  explicit Variables(const T* const* parameters) {
    for_each([&](std::size_t k, int i, int column) {
      x_[static_cast<std::size_t>(column)] = JetType(parameters[k][i], column);
    });
  }

  /// Calls functor(x₀, x₁, …, result). Returns false if the functor returns false.
  template <typename Functor>
  bool call(const Functor& functor, JetType* result) const {
    return call(functor, result, std::make_index_sequence<kArguments>());
  }

  /// Calls visit(k, i, column) for value i of the array x_k, which is the independent variable `column`.
  template <typename Visit>
  static void for_each(Visit&& visit) {
    constexpr int dims[] = {Dims...};
    int column = 0;
    for (std::size_t k = 0; k < kArguments; ++k) {
      for (int i = 0; i < dims[k]; ++i) visit(k, i, column++);
    }
  }

 private:
  static constexpr int offset(std::size_t k) {
    constexpr int dims[] = {Dims...};
    int sum = 0;
    for (std::size_t i = 0; i < k; ++i) sum += dims[i];
    return sum;
  }
  template <typename Functor, std::size_t... K>
  bool call(const Functor& functor, JetType* result, std::index_sequence<K...>) const {
    return functor((x_.data() + offset(K))..., result);
  }

  std::array<JetType, static_cast<std::size_t>(kColumns)> x_;
};

/// Differentiates a functor that is called as functor(x₀, x₁, …, error). The array x_k has Dims[k] values,
/// and the array `error` has Rows values.
template <int Rows, int... Dims>
class AutoDiff {
 public:
  static constexpr int kColumns = Variables<double, Dims...>::kColumns;
  using JetType = typename Variables<double, Dims...>::JetType;
  static constexpr std::size_t kArguments = sizeof...(Dims);

  /// Computes error = f(x). If jacobians[k] is not null, also writes the derivatives with respect to x_k to
  /// jacobians[k], as a column-major Rows × Dims[k] matrix. Returns false if the functor returns false.
  template <typename Functor>
  static bool Differentiate(const Functor& functor, const double* const* parameters, double* error,
                            double** jacobians) {
    std::array<JetType, static_cast<std::size_t>(Rows)> result;
    if (!Variables<double, Dims...>(parameters).call(functor, result.data())) return false;
    for (int row = 0; row < Rows; ++row) error[row] = result[static_cast<std::size_t>(row)].a;
    Variables<double, Dims...>::for_each([&](std::size_t k, int i, int column) {
      if (jacobians[k] == nullptr) return;
      for (int row = 0; row < Rows; ++row)
        jacobians[k][i * Rows + row] = result[static_cast<std::size_t>(row)].v[column];
    });
    return true;
  }
};

/// The sizes of the arguments of a functor.
template <bool IsDynamic, int... Dims>
struct ParameterDims {
  static_assert(!IsDynamic, "the sizes of the arguments must be known at compile time");
  using Parameters = std::integer_sequence<int, Dims...>;
  static constexpr bool kIsDynamic = IsDynamic;
  static constexpr int kNumParameterBlocks = sizeof...(Dims);
  static constexpr int kNumParameters = (0 + ... + Dims);
  static constexpr int GetDim(int k) {
    constexpr int dims[] = {Dims...};
    return dims[k];
  }
  template <typename T>
  using VariablesType = Variables<T, Dims...>;
};
template <int... Dims>
using StaticParameterDims = ParameterDims<false, Dims...>;

/// Computes function_value = f(x) for a functor that is called as functor(x₀, x₁, …, function_value). The
/// array function_value has kNumResiduals values, or dynamic_num_outputs values if kNumResiduals is DYNAMIC.
/// If jacobians[k] is not null, also writes the derivatives with respect to x_k to jacobians[k], as a
/// row-major matrix. Returns false if the functor returns false.
template <int kNumResiduals, typename ParameterDims, typename Functor, typename T>
bool AutoDifferentiate(const Functor& functor, T const* const* parameters, int dynamic_num_outputs,
                       T* function_value, T** jacobians) {
  using VariablesType = typename ParameterDims::template VariablesType<T>;
  const int rows = kNumResiduals == DYNAMIC ? dynamic_num_outputs : kNumResiduals;
  std::vector<typename VariablesType::JetType> result(static_cast<std::size_t>(rows));
  if (!VariablesType(parameters).call(functor, result.data())) return false;
  for (int row = 0; row < rows; ++row) function_value[row] = result[static_cast<std::size_t>(row)].a;
  VariablesType::for_each([&](std::size_t k, int i, int column) {
    if (jacobians[k] == nullptr) return;
    for (int row = 0; row < rows; ++row) {
      jacobians[k][row * ParameterDims::GetDim(static_cast<int>(k)) + i] =
          result[static_cast<std::size_t>(row)].v[column];
    }
  });
  return true;
}

}  // namespace internal
}  // namespace ceres
}  // namespace g2o

#endif  // G2O_AUTODIFF_H
