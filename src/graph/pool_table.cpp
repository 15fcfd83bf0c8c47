// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/graph/pool_table.h"

#include <atomic>
#include <utility>

namespace boxplus::detail {

std::uint32_t PoolTable::new_epoch() noexcept {
  static std::atomic<std::uint32_t> epochs = 0;
  constexpr std::uint32_t kGoldenRatio = 0x9E3779B9;  // 2^32 / golden ratio; spreads its multiples evenly
  return kGoldenRatio * epochs.fetch_add(1, std::memory_order_relaxed);
}

PoolTable::PoolTable(const PoolTable& other)
    : access_(other.access_),
      vertices_of_(other.vertices_of_),
      edges_of_(other.edges_of_),
      last_vertices_(other.last_vertices_),
      last_edges_(other.last_edges_) {
  for (const auto& pool : other.vertices) {
    vertices.push_back(pool->clone());
    vertices.back()->next_generation_ = epoch_;
  }
  for (const auto& pool : other.edges) {
    edges.push_back(pool->clone(vertices));
    edges.back()->next_generation_ = epoch_;
  }
}

PoolTable& PoolTable::operator=(PoolTable&& other) noexcept {
  if (this == &other) return *this;
  vertices = std::move(other.vertices);
  edges = std::move(other.edges);
  access_ = std::move(other.access_);
  vertices_of_ = std::move(other.vertices_of_);
  edges_of_ = std::move(other.edges_of_);
  last_vertices_ = std::exchange(other.last_vertices_, {});
  last_edges_ = std::exchange(other.last_edges_, {});
  epoch_ = std::exchange(other.epoch_, new_epoch());
  return *this;
}

std::uint32_t PoolTable::add_edges(std::unique_ptr<EdgePool> pool) {
  pool->next_generation_ = epoch_;
  access_.reserve(access_.size() + 1);
  edges.push_back(std::move(pool));
  access_.push_back({&typeid(void), nullptr, nullptr});
  return static_cast<std::uint32_t>(edges.size() - 1);
}

}  // namespace boxplus::detail
