// SPDX-License-Identifier: BSD-3-Clause
// Compile-time checks of vertex and edge types. The compiler prints one sentence per mistake.
#pragma once

#include <concepts>
#include <utility>

#include "boxplus/graph/error_function.h"
#include "boxplus/graph/member_names.h"
#include "boxplus/graph/vector_parameters.h"

namespace boxplus::detail {

template <class E, class... A>
inline constexpr bool kCallableUnlessConst = requires(E& e, A&&... a) {
  e.error(std::forward<A>(a)...);
}
|| std::invocable<E&, A...>;

template <class E>
concept JacobiansForSomeTypes = requires {
  requires E::kJacobiansForSomeTypes;
};

/// Whether E can use its Jacobians. False if a member function is named `jacobian` or `jacobians`, but has
/// the wrong signature.
template <class E, class... V>
inline constexpr bool kUsesItsJacobians =
    kAnalytic<E, V...> || JacobiansForSomeTypes<E> || !kNamesJacobianFunction<E>;

/// Returns true. Does not compile unless a graph can hold estimates of type T.
template <class T>
consteval bool check_vertex_type() {
  static_assert(ManifoldType<T>,
                "this type is not a manifold, so it cannot be a vertex: specialize boxplus::Manifold<T> for "
                "it (boxplus/manifold/manifold.h shows how), and include the header that does");
  return true;
}

/// Returns true. Does not compile unless E is an error function of the vertex types V..., and the Jacobians
/// that E defines can be called.
template <class E, class... V>
consteval bool check_edge_type() {
  using detail::Argument, detail::Parameters;
  static_assert(std::copy_constructible<E>,
                "an error function must be copyable: the graph keeps a copy of it");
  static_assert(detail::kHasFunction<E>, "an edge needs a member error(...) const, or to be callable itself");
  if constexpr (detail::Callable<E, Argument<V>...>) {
    static_assert(detail::kAllFit<typename detail::KnownParameters<E>::Type, V...>,
                  "the error function takes a vector of another type than its vertex: estimates that are "
                  "vectors arrive as const boxplus::Vector<S, N>&, N being the size of the vertex");
    static_assert(
        detail::kUsesItsJacobians<E, V...>,
        "the edge has a member function jacobians (or jacobian) that cannot be called as "
        "jacobians(x_1, ..., x_q, J_1, ..., J_q) const, where J_i is an Eigen::Ref of a matrix with "
        "the rows of the error and the columns of x_i (or a template parameter)");
  } else if constexpr (detail::kHasFunction<E>) {
    constexpr bool kLacksConst = detail::kCallableUnlessConst<E, Argument<V>...>;
    constexpr bool kTakesOtherVectors = detail::kTakesOtherVectors<E, Parameters<>, Parameters<V...>>;
    static_assert(!kLacksConst,
                  "the error function must be const: error(...) const, or a lambda that is not mutable");
    static_assert(!kTakesOtherVectors,
                  "the error function takes a vector of another type than its vertex: estimates that are "
                  "vectors arrive as const boxplus::Vector<S, N>&, N being the size of the vertex");
    static_assert(kLacksConst || kTakesOtherVectors,
                  "the error function cannot be called with the estimates of these vertices (in this order)");
  }
  return true;
}

}  // namespace boxplus::detail
