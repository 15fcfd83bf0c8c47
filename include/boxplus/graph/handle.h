// SPDX-License-Identifier: BSD-3-Clause
// Light references to elements of a Graph. They stay valid until their element is removed. Stale handles and
// handles of another graph are detected.
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>

#include "boxplus/graph/stored_estimate.h"

namespace boxplus {

/// The integer name of a vertex: chosen by the user or read from a file, otherwise the next free one.
using Id = std::int64_t;

/// A vertex of any type: slot `slot` of vertex pool `pool`. `generation` tells the elements apart that have
/// used a slot one after the other. It also tells graphs apart, because each counts generations from another
/// number.
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

/// Another name of the same vertex type: VertexHandle<Eigen::Vector2d> and VertexHandle<Vector2> convert into
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
