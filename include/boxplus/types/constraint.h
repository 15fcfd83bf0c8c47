// SPDX-License-Identifier: BSD-3-Clause
// Equality constraints.
#pragma once

#include <cstddef>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "boxplus/graph/error_function.h"

namespace boxplus {

namespace detail {
/// The result of an error function. Has no Type if E cannot be called.
template <class E, class... A>
struct ErrorOf {};
template <class E, class... A>
requires Callable<E, A...>
struct ErrorOf<E, A...> {
  using Type = std::remove_cvref_t<typename UnevaluatedResult<E, A...>::Type>;
};
}  // namespace detail

/// An edge whose error must be zero exactly, and not only as small as its weight makes it:
///
///     graph.add_edge(Constraint([](const auto& a, const auto& b) { return b - a - 1.0; }), a, b);
///
/// E is any error function (graph/error_function.h). optimize() finds a minimum of F among the estimates for
/// which all enabled active constraints vanish, by the method of multipliers (Hestenes, "Multiplier and
/// gradient methods", 1969; Bertsekas, "Constrained optimization and Lagrange multiplier methods", 1982): it
/// runs several times, and shifts the errors of the constraints in between. Report::constraints has the
/// multipliers, and Report::constraint_violation the largest error that is left (NaN if Options::time_limit_s
/// or Options::stop ended the run while planning, so that no error was evaluated). A run is converged only if
/// every error e is at most 1e-9 or, if that is more, 4 ε Σ |∂e/∂x| |x|: the rounding of the estimates x.
///
/// Ω says how the rows of the constraints compare with each other in early runs; the result does not depend
/// on it. Graph::chi2() includes eᵀΩe. A constraint cannot have a robust kernel: optimize() throws
/// InvalidArgument. covariance() takes constraints for measurements with information Ω.
template <class E>
struct Constraint {
  static constexpr std::string_view kName = "Constraint";
  static constexpr bool kIsConstraint = true;
  static constexpr bool kRigid = detail::kIsRigid<E>;
  static constexpr bool kNumeric = detail::WantsNumeric<E>;
  static constexpr bool kJacobiansForSomeTypes = true;

  E function;
  std::vector<double> shift;  ///< added to the error by optimize() during a run; empty otherwise

  explicit Constraint(E error_function) : function(std::move(error_function)) {}

  template <class... X>
  typename detail::ErrorOf<E, const X&...>::Type error(const X&... x) const {
    auto result = detail::evaluate(function, x...);
    for (std::size_t i = 0; i < shift.size(); ++i) {
      if constexpr (requires { result.size(); }) {
        result[i] += shift[i];
      } else {
        result += shift[i];
      }
    }
    return result;
  }

  template <class... A>
  void jacobians(A&&... arguments) const requires requires(const E& e) {
    e.jacobians(std::forward<A>(arguments)...);
  }
  { function.jacobians(std::forward<A>(arguments)...); }
};

}  // namespace boxplus
