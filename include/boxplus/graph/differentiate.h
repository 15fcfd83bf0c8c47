// SPDX-License-Identifier: BSD-3-Clause
// Jacobians of an error function through ⊞: exact by dual numbers, or numeric.
//
// Both fill a column-major rows × cols block; the columns of x_1 come first, then those of x_2, …
#pragma once

#include <algorithm>
#include <vector>

#include "boxplus/autodiff/numeric.h"
#include "boxplus/base/thread_scratch.h"
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

/// x ⊞ δ over dual numbers, where δ = 0 and the derivative of its k-th entry is unit vector `column + k −
/// first`. Entries outside of the dual's window are constant.
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
    auto& delta = thread_scratch<std::vector<S>, struct LiftedDelta>();
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
      for (int c = first; c < last; ++c)
        jacobian[c * rows + i] = r.derivative[static_cast<std::size_t>(c - first)];
    }
    first += kWindow;
  } while (first < cols);
}

/// error ← e(x), J ← ∂e(x ⊞ δ)/∂δ by adaptive central differences
/// (autodiff/numeric.h).
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
  NumericDerivative differentiate;
  int column = 0;
  const auto columns_of = [&](auto& slot) {
    using T = std::remove_reference_t<decltype(slot)>;
    const T original = slot;
    const int dim = boxplus::tangent_dim(original);
    for (int k = 0; k < dim; ++k, ++column) {
      const auto along_k = [&](double h, double* out) {
        delta[static_cast<std::size_t>(k)] = h;
        slot = Manifold<T>::oplus(original, delta.data());
        delta[static_cast<std::size_t>(k)] = 0;
        evaluate_moved(out);
      };
      differentiate(along_k, rows, jacobian + static_cast<std::ptrdiff_t>(column) * rows);
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
