// SPDX-License-Identifier: BSD-3-Clause
// Jacobians of an error function with respect to the step δ of x ⊞ δ: exact, analytic or numeric.
//
// Each function fills a column-major block of rows × cols. The columns of x_1 come first, then the columns of
// x_2, …
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "boxplus/autodiff/numeric.h"
#include "boxplus/base/thread_scratch.h"
#include "boxplus/graph/error_function.h"
#include "boxplus/manifold/lift.h"

namespace boxplus::detail {

/// The tangent size of an argument. For a tail, the sum of the tangent sizes of its elements.
template <class V>
int argument_dim(Argument<V> x) {
  if constexpr (kIsTail<V>) {
    int sum = 0;
    for (const auto& element : x) sum += detail::tangent_dim(element);
    return sum;
  } else {
    return detail::tangent_dim(x);
  }
}

/// An argument that is converted ("lifted") to dual numbers: an estimate, or the elements of a tail. An
/// estimate that consecutive edges share is lifted only once.
template <class V, class S>
class LiftedArgument {
 public:
  /// Lifts the estimate x of the vertex in `slot`, whose columns begin at `column`. Advances `column` to the
  /// next argument.
  void lift(const V& x, std::uint32_t slot, int& column, int first) {
    const int offset = column - first;
    if (!value_ || offset_ != offset) {
      value_.emplace(detail::lift(x, Seed<S>{offset}));
    } else if (slot_ != slot) {
      detail::lift_again(x, Seed<S>{offset}, *value_);
    }
    slot_ = slot;
    offset_ = offset;
    column += detail::tangent_dim(x);
  }
  const Lifted<V, S>& get() const { return *value_; }

 private:
  std::optional<Lifted<V, S>> value_;
  std::uint32_t slot_ = 0;
  int offset_ = 0;
};
template <class T, class S>
class LiftedArgument<Tail<T>, S> {
 public:
  void lift(std::span<const T> x, std::uint32_t, int& column, int first) {
    values_.clear();
    values_.reserve(x.size());
    for (const T& element : x) {
      values_.push_back(detail::lift(element, Seed<S>{column - first}));
      column += detail::tangent_dim(element);
    }
  }
  std::span<const detail::Rebind<T, S>> get() const { return values_; }

 private:
  std::vector<detail::Rebind<T, S>> values_;
};

/// Jacobians by forward-mode dual numbers, exact up to rounding. One object may differentiate several edges,
/// one after the other; no estimate may change in between.
template <class... V>
class AutomaticJacobian {
 public:
  using Scalar = DualFor<V...>;
  static constexpr int kWindow = kDualSize<V...>;

  /// error ← e(x), and columns [first, first + kWindow) of J ← ∂e(x ⊞ δ)/∂δ. `slots`: the slots of the edge's
  /// vertices. The arguments x are the estimates of these vertices.
  template <class E>
  void columns(const E& e, double* error, double* jacobian, int rows, int cols, int first,
               std::span<const std::uint32_t> slots, Argument<V>... x) {
    int column = 0;
    std::size_t position = 0;  // next index in `slots`; a tail does not use its slot, and may be empty
    const auto next_slot = [&] { return position < slots.size() ? slots[position++] : 0; };
    std::apply([&](auto&... a) { (a.lift(x, next_slot(), column, first), ...); }, lifted_);
    const auto result = std::apply([&](const auto&... a) { return evaluate(e, a.get()...); }, lifted_);
    check_row_count(result, rows);
    using R = std::remove_cvref_t<decltype(result)>;
    const int n = kRows<R> != kDynamic ? kRows<R> : rows;
    const int last = kCols<V...> == kWindow ? kWindow : std::min(cols, first + kWindow);
    for (int i = 0; i < n; ++i) {
      const Scalar r(row(result, i));
      error[i] = r.value;
      for (int c = first; c < last; ++c)
        jacobian[c * n + i] = r.derivative[static_cast<std::size_t>(c - first)];
    }
  }

 private:
  std::tuple<LiftedArgument<V, Scalar>...> lifted_;
};

/// error ← e(x), J ← ∂e(x ⊞ δ)/∂δ at δ = 0 by forward-mode dual numbers: all columns, exact up to
/// rounding.
template <class... V, class E>
void automatic_jacobian(const E& e, double* error, double* jacobian, int rows, int cols, Argument<V>... x) {
  constexpr std::array<std::uint32_t, sizeof...(V)> kAnySlots{};
  AutomaticJacobian<V...> differentiate;
  int first = 0;
  do {
    differentiate.columns(e, error, jacobian, rows, cols, first, kAnySlots, x...);
    first += AutomaticJacobian<V...>::kWindow;
  } while (first < cols);
}

/// J ← the Jacobians that e.jacobians() computes.
template <class... V, class E>
void analytic_jacobian(const E& e, double* jacobian, int rows, Argument<V>... x) {
  constexpr int kRowsOfEdge = kRows<Result<E, V...>>;
  const auto next = [&]<class A>(std::type_identity<A>, Argument<A> a) {
    const int cols = argument_dim<A>(a);
    JacobianBlock<A, kRowsOfEdge> block(jacobian, rows, cols);
    jacobian += static_cast<std::ptrdiff_t>(rows) * cols;
    return block;
  };
  // Braced initialization evaluates from left to right.
  std::tuple<JacobianBlock<V, kRowsOfEdge>...> blocks{next(std::type_identity<V>{}, x)...};
  std::apply([&](auto&... J) { e.jacobians(x..., J...); }, blocks);
}

/// The working memory of numeric_jacobian(). Each thread has one such object.
struct NumericMemory {
  std::vector<double> delta;
  NumericDerivative differentiate = NumericDerivative();
};

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
  // An error function may call this function again.
  const BorrowedScratch<NumericMemory, struct OfNumericJacobian> memory;
  std::vector<double>& delta = memory->delta;
  NumericDerivative& differentiate = memory->differentiate;
  delta.assign(static_cast<std::size_t>(cols), 0.0);
  int column = 0;
  const auto columns_of = [&](auto& slot) {
    using T = std::remove_reference_t<decltype(slot)>;
    const T original = slot;
    const int dim = detail::tangent_dim(original);
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

}  // namespace boxplus::detail
