// SPDX-License-Identifier: BSD-3-Clause
#include "results.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <utility>

#include "boxplus/base/error.h"

namespace boxplus::app {
namespace {

/// The id of a vertex or parameter, as one number.
std::uint64_t key_of(const detail::VertexPool& pool, std::uint32_t slot) {
  return 2 * static_cast<std::uint64_t>(pool.id(slot)) + (pool.parameter(slot) ? 1 : 0);
}

std::optional<VertexRef> find(const Graph& graph, std::uint64_t key) {
  const auto id = static_cast<Id>(key / 2);
  return key % 2 == 1 ? graph.find_parameter(id) : graph.find_vertex(id);
}

}  // namespace

Results::Results(const Graph& graph, std::span<const EdgeRef> own_edges) {
  std::vector<std::vector<bool>> own;
  for (const auto& pool : graph.vertex_pools()) own.emplace_back(pool->slots(), false);
  for (const EdgeRef& edge : own_edges) {
    const detail::EdgePool& pool = *graph.edge_pools()[edge.pool];
    const std::span<const std::uint32_t> slots = pool.vertex_slots(edge.slot);
    for (std::size_t i = 0; i < slots.size(); ++i)
      own[pool.vertex_pool(edge.slot, static_cast<int>(i))][slots[i]] = true;
  }
  for (std::size_t p = 0; p < own.size(); ++p) {
    Pool saved;
    for (std::uint32_t slot = 0; slot < own[p].size(); ++slot) {
      if (own[p][slot]) saved.slots.push_back(slot);
    }
    graph.vertex_pools()[p]->save(saved.slots, saved.before);
    pools_.push_back(std::move(saved));
  }
}

std::vector<std::uint64_t> Results::changes(const Graph& graph) const {
  std::vector<std::uint64_t> words;
  std::vector<double> delta;
  for (std::size_t p = 0; p < pools_.size(); ++p) {
    const detail::VertexPool& pool = *graph.vertex_pools()[p];
    for (std::size_t k = 0; k < pools_[p].slots.size(); ++k) {
      const std::uint32_t slot = pools_[p].slots[k];
      delta.resize(static_cast<std::size_t>(pool.tangent_dim(slot)));
      pool.difference(slot, nullptr, *pools_[p].before, k, delta.data());
      if (std::ranges::all_of(delta, [](double entry) { return entry == 0; })) continue;
      words.push_back(key_of(pool, slot));
      words.push_back(delta.size());
      for (const double entry : delta) words.push_back(std::bit_cast<std::uint64_t>(entry));
    }
  }
  return words;
}

ChangedGraph::ChangedGraph(Graph& graph, bool is_part) : graph_(graph), is_part_(is_part) {
  for (const auto& pool : graph.vertex_pools()) has_changed_.emplace_back(pool->slots(), false);
}

void ChangedGraph::apply(std::span<const std::uint64_t> changes) {
  std::vector<double> delta;
  while (!changes.empty()) {
    const std::optional<VertexRef> vertex = find(graph_, changes[0]);
    delta.resize(changes[1]);
    for (std::size_t entry = 0; entry < delta.size(); ++entry)
      delta[entry] = std::bit_cast<double>(changes[kHeader + entry]);
    changes = changes.subspan(kHeader + delta.size());
    if (!vertex && is_part_) continue;
    if (!vertex || static_cast<std::size_t>(graph_.tangent_dim(*vertex)) != delta.size())
      throw InvalidArgument(
          "the file has changed since the estimates were computed, so they cannot be applied");
    if (has_changed_[vertex->pool][vertex->slot]) continue;
    has_changed_[vertex->pool][vertex->slot] = true;
    constexpr std::array<std::uint32_t, 1> kFirst{0};
    graph_.vertex_pools()[vertex->pool]->oplus(std::array{vertex->slot}, kFirst, delta.data());
  }
}

}  // namespace boxplus::app
