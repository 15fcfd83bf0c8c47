// SPDX-License-Identifier: BSD-3-Clause
// Checks the Jacobians of an edge, for the tests of users. Needs no test framework:
//
//     const JacobianCheck check = check_jacobians(MyEdge{…}, x_1, x_2);
//     if (!check.ok) std::cerr << check.message;
//
// If the error function is a template over the scalar, the check compares the exact Jacobians (by dual
// numbers) with numeric Jacobians. If the edge has a member jacobians(), the check compares its result with
// the exact Jacobians or, without dual numbers, with the numeric Jacobians. Choose estimates at which the
// error is neither zero nor at a kink, so that no term of the Jacobians vanishes.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "boxplus/graph/check_types.h"
#include "boxplus/graph/differentiate.h"
#include "boxplus/graph/edge_pool.h"
#include "boxplus/graph/type_name.h"

namespace boxplus {

struct JacobianTolerances {
  double analytic = 1e-10;  ///< between analytic and exact, relative to the largest entry (at least 1)
  double numeric = 1e-7;    ///< between numeric and the other two, with the same scale
};

struct [[nodiscard]] JacobianCheck {
  bool ok = true;
  /// The Jacobians that optimize() uses. to_string(source) is "analytic" (member jacobians()), "exact" or
  /// "numeric".
  detail::JacobianSource source = detail::JacobianSource::kNumeric;
  /// Each wrong block, with its worst entry: "∂e/∂x_2 (SE2), row 1, column 2: expected …, got … (analytic
  /// against exact)". Rows, columns and vertices count from 1. Empty if ok.
  std::string message;
  double largest_difference = 0;  ///< relative to the largest entry of the Jacobian (at least 1)
};

namespace detail {

/// The columns of the Jacobian that belong to one argument.
struct ArgumentColumns {
  std::string_view type;
  int first = 0, count = 0;
};

/// Compares two column-major Jacobians of `rows` rows, and adds their differences to `check`.
void compare_jacobians(std::span<const double> expected, std::span<const double> actual, int rows,
                       double tolerance, std::span<const ArgumentColumns> arguments, std::string_view pair,
                       JacobianCheck& check);

/// The type in which the error function receives an estimate. In a graph, it receives the same type.
template <class A>
struct CheckedType {
  using Type = StoredEstimate<A>;
  static const Type& argument(const Type& x) { return x; }
};
template <EigenColumn A>
struct CheckedType<A> {
  using Type = StoredEstimate<A>;
  static Type argument(const A& x) { return x; }
};
template <class T>
struct CheckedType<std::vector<T>> {
  using Type = detail::Tail<StoredEstimate<T>>;
  static std::vector<StoredEstimate<T>> argument(const std::vector<T>& x) { return {x.begin(), x.end()}; }
};

template <class... V, class E>
JacobianCheck check_jacobians_of(const E& e, const JacobianTolerances& tolerances, Argument<V>... x) {
  static_assert(check_edge_type<E, V...>());
  const int rows = row_count(evaluate(e, x...));
  int cols = 0;
  const auto columns = [&](std::string_view type, int count) {
    cols += count;
    return ArgumentColumns{type, cols - count, count};
  };
  const std::array<ArgumentColumns, sizeof...(V)> arguments{
      columns(type_name<ElementOf<V>>(), argument_dim<V>(x))...};
  const auto size = static_cast<std::size_t>(rows) * static_cast<std::size_t>(cols);
  std::vector<double> error(static_cast<std::size_t>(rows)), numeric(size), automatic(size), analytic(size);

  JacobianCheck check;
  check.source = kJacobianSource<E, V...>;
  numeric_jacobian<V...>(e, error.data(), numeric.data(), rows, cols, x...);
  if constexpr (kDifferentiable<E, V...>) {
    automatic_jacobian<V...>(e, error.data(), automatic.data(), rows, cols, x...);
    compare_jacobians(numeric, automatic, rows, tolerances.numeric, arguments, "exact against numeric",
                      check);
  }
  if constexpr (kAnalytic<E, V...>) {
    analytic_jacobian<V...>(e, analytic.data(), rows, x...);
    if constexpr (kDifferentiable<E, V...>) {
      compare_jacobians(automatic, analytic, rows, tolerances.analytic, arguments, "analytic against exact",
                        check);
    } else {
      compare_jacobians(numeric, analytic, rows, tolerances.numeric, arguments, "analytic against numeric",
                        check);
    }
  }
  return check;
}

}  // namespace detail

/// Checks an edge at the given estimates. If an argument of the edge takes any number of vertices, pass a
/// std::vector of estimates for it.
template <class E, class... X>
JacobianCheck check_jacobians(const JacobianTolerances& tolerances, const E& e, const X&... x) {
  return detail::check_jacobians_of<typename detail::CheckedType<X>::Type...>(
      e, tolerances, detail::CheckedType<X>::argument(x)...);
}
template <class E, class... X>
JacobianCheck check_jacobians(const E& e, const X&... x) {
  return check_jacobians(JacobianTolerances{}, e, x...);
}

}  // namespace boxplus
