// SPDX-License-Identifier: BSD-3-Clause
// The pools of a graph: one for each type of vertices, and one for each type of edges and of their vertices.
#pragma once

#include <cstdint>
#include <memory>
#include <typeindex>
#include <typeinfo>
#include <unordered_map>
#include <utility>
#include <vector>

#include "boxplus/graph/typed_edge_pool.h"
#include "boxplus/graph/typed_vertex_pool.h"

namespace boxplus::detail {

/// Access to the error functions of an edge pool, for callers that know their type E but not the types of the
/// vertices.
struct EdgeAccess {
  const std::type_info* type;
  const void* (*value)(const EdgePool&, std::uint32_t slot);
  void (*exchange)(EdgePool&, std::uint32_t slot, void* error);

  template <class E, class Pool>
  static EdgeAccess of() {
    return {&typeid(E),
            [](const EdgePool& pool, std::uint32_t slot) -> const void* {
              return &static_cast<const Pool&>(pool).value(slot);
            },
            [](EdgePool& pool, std::uint32_t slot, void* error) {
              static_cast<Pool&>(pool).exchange(slot, std::move(*static_cast<E*>(error)));
            }};
  }
};

/// Finds pools by the types of their elements. A handle has the index of its pool.
class PoolTable {
 public:
  PoolTable() = default;
  ~PoolTable() = default;
  /// A deep copy. The elements keep their generations, so that handles are also valid for the copy. The
  /// generations of new elements start at a different number.
  PoolTable(const PoolTable& other);
  PoolTable& operator=(const PoolTable&) = delete;
  /// `other` is then empty, and starts at a different number.
  PoolTable& operator=(PoolTable&& other) noexcept;

  /// The index of the pool of these vertices. Creates the pool if there is none.
  template <class T>
  std::uint32_t require_vertices() {
    if (last_vertices_.type == &typeid(T)) return last_vertices_.index;
    const auto [entry, fresh] =
        vertices_of_.try_emplace(typeid(T), static_cast<std::uint32_t>(vertices.size()));
    if (fresh) {
      vertices.push_back(std::make_unique<TypedVertexPool<T>>());
      vertices.back()->next_generation_ = epoch_;
    }
    last_vertices_ = {&typeid(T), entry->second};
    return entry->second;
  }

  /// The index of the pool of these edges. Creates the pool if there is none.
  template <class E, class... V>
  std::uint32_t require_edges() {
    using Pool = TypedEdgePool<E, V...>;
    if (last_edges_.type == &typeid(Pool)) return last_edges_.index;
    const auto [entry, fresh] = edges_of_.try_emplace(typeid(Pool), static_cast<std::uint32_t>(edges.size()));
    if (fresh) {
      const std::vector<std::uint32_t> indices{require_vertices<ElementOf<V>>()...};
      typename Pool::VertexPools pools{static_cast<const TypedVertexPool<ElementOf<V>>*>(
          vertices[require_vertices<ElementOf<V>>()].get())...};
      edges.push_back(std::make_unique<Pool>(indices, pools));
      edges.back()->next_generation_ = epoch_;
      access_.push_back(EdgeAccess::of<E, Pool>());
    }
    last_edges_ = {&typeid(Pool), entry->second};
    return entry->second;
  }
  /// Adds a pool whose types are known only at run time, and returns its index.
  std::uint32_t add_edges(std::unique_ptr<EdgePool> pool);

  const EdgeAccess& access(std::uint32_t edge_pool) const { return access_[edge_pool]; }

  std::vector<std::unique_ptr<VertexPool>> vertices;
  std::vector<std::unique_ptr<EdgePool>> edges;

 private:
  /// The pool to which the last element was added. Because most elements are added in runs of one type, this
  /// saves most look-ups, which hash the name of the type.
  struct LastPool {
    const std::type_info* type = nullptr;
    std::uint32_t index = 0;
  };

  /// The first generation of the pools. Each call returns a different number, and the numbers are as far
  /// apart as possible. Therefore, a graph detects handles of another graph and handles from before clear().
  /// Thread-safe.
  static std::uint32_t new_epoch() noexcept;

  std::vector<EdgeAccess> access_;  // per edge pool
  std::unordered_map<std::type_index, std::uint32_t> vertices_of_, edges_of_;
  LastPool last_vertices_, last_edges_;
  std::uint32_t epoch_ = new_epoch();
};

}  // namespace boxplus::detail
