// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "g2o/core/optimizable_graph.h"

namespace g2o {
namespace internal {

/// Prefetches the first `bytes` of an object. The object may be smaller, and the pointer may be null.
inline void prefetch(const void* object, std::size_t bytes) {
#if defined(__GNUC__)
  constexpr std::size_t kLine = 64;
  const auto begin = reinterpret_cast<std::uintptr_t>(object);  // integers may point past the object
  for (std::size_t at = 0; at < bytes; at += kLine) {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): the address is only prefetched
    __builtin_prefetch(reinterpret_cast<const void*>(begin + at));
  }
#else
  static_cast<void>(object);
  static_cast<void>(bytes);
#endif
}

/// An edge is prefetched this number of edges before its turn. Its vertices are prefetched later, when the
/// edge is in the cache, because their addresses are in the edge.
inline constexpr int kEdgesAhead = 6, kVerticesAhead = 3;

/// Calls f for each edge. Meanwhile, prefetches the next edges and their vertices, because each of them is a
/// separate heap object.
template <class F>
void for_each_ahead(const OptimizableGraph::EdgeContainer& edges, F&& f) {
  constexpr std::size_t kEdgeBytes = 1024, kVertexBytes = 512;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    if (k + kEdgesAhead < edges.size()) prefetch(edges[k + kEdgesAhead], kEdgeBytes);
    if (k + kVerticesAhead < edges.size()) {
      for (const HyperGraph::Vertex* v : edges[k + kVerticesAhead]->vertices()) prefetch(v, kVertexBytes);
    }
    f(*edges[k]);
  }
}

/// Calls f for each vertex, and prefetches the next vertices.
template <class F>
void for_each_ahead(const OptimizableGraph::VertexContainer& vertices, F&& f) {
  constexpr std::size_t kAhead = 8, kVertexBytes = 256;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (k + kAhead < vertices.size()) prefetch(vertices[k + kAhead], kVertexBytes);
    f(*vertices[k]);
  }
}

}  // namespace internal
}  // namespace g2o
