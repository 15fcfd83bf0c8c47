// SPDX-License-Identifier: BSD-3-Clause
// Light references to elements of a Graph. They stay valid until their element is removed; a stale one is
// detected.
#pragma once

#include <compare>
#include <cstdint>

namespace boxplus {

/// The integer name of a vertex: chosen by the user or the file, else the next free one.
using Id = std::int64_t;

/// A vertex of any type: slot `slot` of vertex pool `pool`; `generation` tells a re-used slot from its
/// predecessor.
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

/// An edge whose error function is an E.
template <class E>
struct EdgeHandle : EdgeRef {
  using EdgeType = E;
};

}  // namespace boxplus
