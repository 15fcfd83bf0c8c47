// SPDX-License-Identifier: BSD-3-Clause
// Jacobians of an error function through ⊞: exact by dual numbers, or numeric.
//
// Both fill a column-major rows × cols block; the columns of x_1 come first, then those of x_2, …
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "boxplus/graph/error_function.h"

namespace boxplus::edge {

/// Tangent size of an argument: that of its estimate, or the sum over a tail.
template <class V>
int argument_dim(Argument<V> x) {
  if constexpr (kIsTail<V>) {
    int sum = 0;
    for (const auto& element : x) sum += boxplus::tangent_dim(element);
    return sum;
  } else {
    return boxplus::tangent_dim(x);
  }
}

/// x ⊞ δ over dual numbers, where δ = 0 and the derivative of its k-th entry is unit vector `column + k − first`.
/// Entries outside of the dual's window are constant.
template <class S, class T>
boxplus::Rebind<T, S> lift(const T& x, int column, int first) {
  constexpr int kWindow = static_cast<int>(std::tuple_size<decltype(S::derivative)>::value);
  constexpr int kDim = Manifold<T>::kDim;
  auto lifted = Manifold<T>::template cast<S>(x);
  const int dim = boxplus::tangent_dim(x);
  if (column >= first + kWindow || column + dim <= first) return lifted;
  const auto seed = [&](auto& delta) {
    for (int k = 0; k < dim; ++k) {
      delta[static_cast<std::size_t>(k)] = S(0.0);
      const int derivative = column + k - first;
      if (derivative >= 0 && derivative < kWindow) {
        delta[static_cast<std::size_t>(k)].derivative[static_cast<std::size_t>(derivative)] = 1;
      }
    }
    return Manifold<boxplus::Rebind<T, S>>::oplus(lifted, delta.data());
  };
  if constexpr (kDim == kDynamic) {
    thread_local std::vector<S> delta;
    delta.resize(static_cast<std::size_t>(dim));
    return seed(delta);
  } else {
    std::array<S, static_cast<std::size_t>(kDim > 0 ? kDim : 1)> delta;
    return seed(delta);
  }
}

/// An argument over dual numbers: the estimate itself, or storage for the elements of a tail.
template <class V, class S>
struct LiftedArgument {
  Lifted<V, S> value;
  LiftedArgument(const V& x, int& column, int first) : value(lift<S>(x, column, first)) {
    column += boxplus::tangent_dim(x);
  }
  const Lifted<V, S>& get() const { return value; }
};
template <class T, class S>
struct LiftedArgument<Tail<T>, S> {
  std::vector<boxplus::Rebind<T, S>> values;
  LiftedArgument(std::span<const T> x, int& column, int first) {
    values.reserve(x.size());
    for (const T& element : x) {
      values.push_back(lift<S>(element, column, first));
      column += boxplus::tangent_dim(element);
    }
  }
  std::span<const boxplus::Rebind<T, S>> get() const { return values; }
};

/// error ← e(x), J ← ∂e(x ⊞ δ)/∂δ by forward-mode dual numbers; exact up to rounding.
template <class... V, class E>
void automatic_jacobian(const E& e, double* error, double* jacobian, int rows, int cols, Argument<V>... x) {
  using S = DualFor<V...>;
  constexpr int kWindow = kDualSize<V...>;
  int first = 0;
  do {
    int column = 0;
    // Braced initialisation evaluates from left to right: each argument takes its columns in turn.
    const std::tuple<LiftedArgument<V, S>...> lifted{LiftedArgument<V, S>(x, column, first)...};
    const auto result = std::apply([&](const auto&... a) { return evaluate(e, a.get()...); }, lifted);
    check_row_count(result, rows);
    const int last = std::min(cols, first + kWindow);
    for (int i = 0; i < rows; ++i) {
      const S r(row(result, i));
      error[i] = r.value;
      for (int c = first; c < last; ++c) jacobian[c * rows + i] = r.derivative[static_cast<std::size_t>(c - first)];
    }
    first += kWindow;
  } while (first < cols);
}

/// One numeric derivative by Ridders' method ("Accurate computation of F′(x) and F′(x) F″(x)", 1982): central
/// differences over shrinking steps, extrapolated to zero; per row the entry of the tableau with the least
/// estimated error is kept, so the step adapts to the scale of the function.
/// `evaluate_at(h, out)` writes e(x ⊞ h·δ) as `rows` numbers.
template <class F>
void ridders_derivative(F&& evaluate_at, int rows, double* out) {
  constexpr int kSteps = 8;
  constexpr double kShrink = 1.6, kFirstStep = 2e-2;
  thread_local std::vector<double> scratch;
  const auto n = static_cast<std::size_t>(rows);
  scratch.assign(n * (2 + 2 * kSteps + 1), 0.0);
  double* plus = scratch.data();
  double* minus = plus + n;
  double* previous = minus + n;           // kSteps columns of the tableau's last line
  double* current = previous + kSteps * n;
  double* best_error = current + kSteps * n;
  std::fill_n(best_error, n, std::numeric_limits<double>::infinity());

  double step = kFirstStep;
  for (int k = 0; k < kSteps; ++k, step /= kShrink) {
    evaluate_at(step, plus);
    evaluate_at(-step, minus);
    for (std::size_t i = 0; i < n; ++i) {
      current[i] = (plus[i] - minus[i]) / (2 * step);
      if (k == 0) out[i] = current[i];
      double factor = kShrink * kShrink;
      for (int j = 1; j <= k; ++j, factor *= kShrink * kShrink) {
        const std::size_t at = static_cast<std::size_t>(j) * n + i, before = at - n;
        current[at] = (current[before] * factor - previous[before]) / (factor - 1);
        const double estimate = std::max(std::abs(current[at] - current[before]), std::abs(current[at] - previous[before]));
        if (estimate <= best_error[i]) {
          best_error[i] = estimate;
          out[i] = current[at];
        }
      }
    }
    std::swap(previous, current);
  }
}

/// error ← e(x), J ← ∂e(x ⊞ δ)/∂δ by adaptive central differences.
template <class... V, class E>
void numeric_jacobian(const E& e, double* error, double* jacobian, int rows, int cols, Argument<V>... x) {
  copy_rows(evaluate(e, x...), rows, error);
  std::tuple<std::conditional_t<kIsTail<V>, std::vector<ElementOf<V>>, ElementOf<V>>...> moved{[&] {
    if constexpr (kIsTail<V>) {
      return std::vector<ElementOf<V>>(x.begin(), x.end());
    } else {
      return x;
    }
  }()...};
  const auto evaluate_moved = [&](double* out) {
    std::apply([&](const auto&... a) { copy_rows(evaluate(e, Argument<V>(a)...), rows, out); }, moved);
  };
  std::vector<double> delta(static_cast<std::size_t>(cols), 0.0);
  int column = 0;
  const auto columns_of = [&](auto& slot) {
    using T = std::remove_reference_t<decltype(slot)>;
    const T original = slot;
    const int dim = boxplus::tangent_dim(original);
    for (int k = 0; k < dim; ++k, ++column) {
      ridders_derivative(
          [&](double h, double* out) {
            delta[static_cast<std::size_t>(k)] = h;
            slot = Manifold<T>::oplus(original, delta.data());
            delta[static_cast<std::size_t>(k)] = 0;
            evaluate_moved(out);
          },
          rows, jacobian + static_cast<std::ptrdiff_t>(column) * rows);
    }
    slot = original;
  };
  const auto visit = [&](auto& argument) {
    if constexpr (ManifoldType<std::remove_cvref_t<decltype(argument)>>) {
      columns_of(argument);
    } else {
      for (auto& element : argument) columns_of(element);
    }
  };
  std::apply([&](auto&... arguments) { (visit(arguments), ...); }, moved);
}

}  // namespace boxplus::edge
