// SPDX-License-Identifier: BSD-3-Clause
#include "results.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace boxplus::app {

Results::Results(const Graph& graph, std::span<const EdgeRef> own_edges) {
  for (const auto& pool : graph.vertex_pools()) {
    Pool saved;
    for (std::uint32_t slot = 0; slot < pool->slots(); ++slot) {
      if (pool->alive(slot)) saved.slots.push_back(slot);
    }
    saved.own.resize(pool->slots());
    pool->save(saved.slots, saved.before);
    saved.same = pool->make_store();
    saved.same->copy_estimates(saved.slots, *pool);
    pools_.push_back(std::move(saved));
  }
  for (const EdgeRef& edge : own_edges) {
    const detail::EdgePool& pool = *graph.edge_pools()[edge.pool];
    const std::span<const std::uint32_t> slots = pool.vertex_slots(edge.slot);
    for (std::size_t i = 0; i < slots.size(); ++i)
      pools_[pool.vertex_pool(edge.slot, static_cast<int>(i))].own[slots[i]] = 1;
  }
}

/// Of each own vertex that has moved: its pool and its number there, and the δ for which before ⊞ δ is its
/// estimate.
std::vector<std::uint64_t> Results::changes(const Graph& graph) const {
  std::vector<std::uint64_t> words;
  std::vector<double> delta;
  for (std::uint32_t p = 0; p < pools_.size(); ++p) {
    const detail::VertexPool& pool = *graph.vertex_pools()[p];
    for (std::uint32_t k = 0; k < pools_[p].slots.size(); ++k) {
      const std::uint32_t slot = pools_[p].slots[k];
      if (pools_[p].own[slot] == 0) continue;
      delta.resize(static_cast<std::size_t>(pool.tangent_dim(slot)));
      pool.difference(slot, nullptr, *pools_[p].before, k, delta.data());
      if (std::ranges::all_of(delta, [](double entry) { return entry == 0; })) continue;
      words.push_back((std::uint64_t{p} << 32) + k);
      for (const double entry : delta) words.push_back(std::bit_cast<std::uint64_t>(entry));
    }
  }
  return words;
}

/// Takes back the initial guesses of other vertices.
void Results::leave_own(Graph& graph) const {
  for (std::size_t p = 0; p < pools_.size(); ++p) {
    std::vector<std::uint32_t> others = pools_[p].slots;
    std::erase_if(others, [&](std::uint32_t slot) { return pools_[p].own[slot] != 0; });
    graph.vertex_pools()[p]->copy_estimates(others, *pools_[p].same);
  }
}

void Results::collect(Graph& graph, mpi::Communicator& communicator) const {
  const std::vector<std::uint64_t> words =
      communicator.gather_at_first(communicator.is_first() ? std::vector<std::uint64_t>() : changes(graph));
  if (communicator.is_first()) leave_own(graph);
  for (std::size_t i = 0; i < words.size();) {
    const auto p = static_cast<std::uint32_t>(words[i] >> 32), k = static_cast<std::uint32_t>(words[i]);
    detail::VertexPool& pool = *graph.vertex_pools()[p];
    const std::array<std::uint32_t, 1> slot{pools_[p].slots[k]}, offset{0};
    std::vector<double> delta(static_cast<std::size_t>(pool.tangent_dim(slot[0])));
    for (std::size_t entry = 0; entry < delta.size(); ++entry)
      delta[entry] = std::bit_cast<double>(words[i + 1 + entry]);
    const bool is_own = pools_[p].own[slot[0]] != 0;  // then it has the same estimate in both processes
    if (!is_own) pool.set_to_sum(slot, *pools_[p].same, offset, delta.data());
    i += 1 + delta.size();
  }
}

}  // namespace boxplus::app
