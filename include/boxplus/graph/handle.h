// SPDX-License-Identifier: BSD-3-Clause
// Lightweight references to elements of a Graph. They stay valid until their element is removed. The graph
// detects stale handles and handles of another graph.
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>

#include "boxplus/graph/stored_estimate.h"

namespace boxplus {

/// The integer name of a vertex: chosen by the user or read from a file, otherwise the next free number.
using Id = std::int64_t;

/// A vertex of any type, in slot `slot` of vertex pool `pool`. `generation` distinguishes the elements that
/// use the same slot one after the other. It also distinguishes graphs, because each graph starts to count
/// generations at a different number.
struct VertexRef {
  std::uint32_t pool = 0xFFFFFFFFu;
  std::uint32_t slot = 0;
  std::uint32_t generation = 0;
  auto operator<=>(const VertexRef&) const = default;
};

/// An edge of any type.
struct EdgeRef {
  std::uint32_t pool = 0xFFFFFFFFu;
  std::uint32_t slot = 0;
  std::uint32_t generation = 0;
  auto operator<=>(const EdgeRef&) const = default;
};

/// A vertex whose estimate is a T.
template <class T>
struct VertexHandle : VertexRef {
  using Estimate = T;
};

/// A second name for the same vertex type: VertexHandle<Eigen::Vector2d> and VertexHandle<Vector2> convert to
/// each other.
template <class T>
requires(!std::same_as<T, detail::StoredEstimate<T>>) struct VertexHandle<T>
    : VertexHandle<detail::StoredEstimate<T>> {
  VertexHandle() = default;
  VertexHandle(const VertexHandle<detail::StoredEstimate<T>>& vertex)  // NOLINT(google-explicit-constructor)
      : VertexHandle<detail::StoredEstimate<T>>(vertex) {}
  explicit VertexHandle(const VertexRef& vertex) : VertexHandle<detail::StoredEstimate<T>>{vertex} {}
};

/// An edge whose error function is an E.
template <class E>
struct EdgeHandle : EdgeRef {
  using EdgeType = E;
};

}  // namespace boxplus
