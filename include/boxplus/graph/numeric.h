// SPDX-License-Identifier: BSD-3-Clause
// Numeric Jacobians for one edge: graph.add_edge(Numeric{edge}, vertex).
#pragma once

#include <utility>

#include "boxplus/graph/error_function.h"

namespace boxplus {

/// Wraps an error function, so that its Jacobians are numeric.
template <class E>
struct Numeric {
  static constexpr bool kNumeric = true;
  E function;
  template <class... A>
  requires detail::Callable<E, A...>
  auto operator()(A&&... a) const { return detail::call(function, std::forward<A>(a)...); }
};
template <class E>
Numeric(E) -> Numeric<E>;

}  // namespace boxplus
