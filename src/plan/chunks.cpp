// SPDX-License-Identifier: BSD-3-Clause
#include "plan/chunks.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "base/paced_stop.h"
#include "plan/edge_targets.h"

namespace boxplus {
namespace {

/// Divides the block columns into contiguous ranges. About the same number of edges touches each range.
std::vector<std::uint32_t> share_columns(const Graph& graph, const ActiveSet& active, int workers,
                                         PacedStop& pace) {
  if (workers == 1) return {0, static_cast<std::uint32_t>(active.block_vertex.size())};
  std::vector<std::uint64_t> weight(active.block_vertex.size(), 1);
  for_each_active_edge(graph, active, pace,
                       [&](std::uint32_t, std::uint32_t, const std::vector<std::uint32_t>& blocks) {
                         for (std::uint32_t block : blocks) {
                           if (block != ActiveSet::kInactive) ++weight[block];
                         }
                       });
  const std::uint64_t total = std::accumulate(weight.begin(), weight.end(), std::uint64_t{0});
  std::vector<std::uint32_t> bounds{0};
  std::uint64_t sum = 0;
  for (std::uint32_t block = 0; block < weight.size(); ++block) {
    sum += weight[block];
    const auto share = static_cast<std::uint64_t>(bounds.size());
    if (bounds.size() < static_cast<std::size_t>(workers) &&
        sum * static_cast<std::uint64_t>(workers) >= total * share) {
      bounds.push_back(block + 1);
    }
  }
  bounds.push_back(static_cast<std::uint32_t>(weight.size()));
  return bounds;
}

struct PlacedEdge {
  std::uint32_t pool, edge;
};

/// The number of eliminated vertices whose edges are linearized together.
constexpr std::uint32_t kVerticesPerBatch = 64;

/// The active edges, batch by batch of eliminated vertices, and then the edges that touch none. Within a
/// batch, they are sorted by pool and slot. So tiles are full, and the values that a batch changes stay in
/// the cache.
class SortedEdges {
 public:
  SortedEdges(const Graph& graph, const ActiveSet& active, PacedStop& pace)
      : eliminated_(active.eliminated_blocks), start_(batches() + 2, 0) {
    for_each_active_edge(graph, active, pace, [&](std::uint32_t, std::uint32_t, const auto& blocks) {
      ++start_[batch_of(blocks) + 1];
    });
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    edges_.resize(start_.back());
    std::vector<std::uint32_t> next = start_;
    for_each_active_edge(graph, active, pace,
                         [&](std::uint32_t pool, std::uint32_t edge, const auto& blocks) {
                           edges_[next[batch_of(blocks)]++] = {pool, edge};
                         });
  }

  std::uint32_t batches() const { return (eliminated_ + kVerticesPerBatch - 1) / kVerticesPerBatch; }
  std::uint32_t end_column(std::uint32_t batch) const {
    return std::min((batch + 1) * kVerticesPerBatch, eliminated_);
  }
  /// The edges of the batches [first, last). The batch batches() contains the edges that touch no eliminated
  /// vertex.
  std::span<const PlacedEdge> of_batches(std::uint32_t first, std::uint32_t last) const {
    return std::span(edges_).subspan(start_[first], start_[last] - start_[first]);
  }

  /// Divides the batches into contiguous ranges with about the same number of edges. Returns the first batch
  /// of each range, and batches().
  std::vector<std::uint32_t> share_batches(int count) const {
    std::vector<std::uint32_t> bounds{0};
    const std::uint64_t total = start_[batches()];
    for (std::uint32_t batch = 1; batch < batches(); ++batch) {
      const auto parts = static_cast<std::uint64_t>(bounds.size());
      if (parts < static_cast<std::uint64_t>(count) &&
          start_[batch] * static_cast<std::uint64_t>(count) >= total * parts)
        bounds.push_back(batch);
    }
    bounds.push_back(batches());
    return bounds;
  }

 private:
  std::uint32_t batch_of(const std::vector<std::uint32_t>& blocks) const {
    const std::uint32_t first = *std::min_element(blocks.begin(), blocks.end());
    return first < eliminated_ ? first / kVerticesPerBatch : batches();
  }

  std::uint32_t eliminated_;
  std::vector<std::uint32_t> start_;  // per batch
  std::vector<PlacedEdge> edges_;
};

/// Builds the scatter map of one chunk.
class ChunkBuilder {
 public:
  ChunkBuilder(const Graph& graph, const ActiveSet& active, const Plan& plan, Chunk chunk,
               const StopToken& stop)
      : graph_(graph),
        active_(active),
        plan_(plan),
        chunk_(std::move(chunk)),
        shift_{.shared = chunk_.copy.in_values - plan.first_stored_value()},
        scatter_of_(graph.edge_pools().size(), ActiveSet::kInactive),
        pace_(stop) {}

  /// Adds all active edges that touch the chunk.
  Chunk build_from_all() {
    begin_batch();
    for_each_active_edge(graph_, active_, pace_,
                         [&](std::uint32_t pool, std::uint32_t edge, const auto& blocks) {
                           if (touches(chunk_, blocks)) append(pool, edge, blocks);
                         });
    return std::move(chunk_);
  }

  /// Adds the edges of the batches [first, last), and in the last chunk also the edges that touch no
  /// eliminated vertex.
  Chunk build_from(const SortedEdges& edges, std::uint32_t first, std::uint32_t last) {
    make_room(edges.of_batches(first, last));
    for (std::uint32_t batch = first; batch < last; ++batch) {
      if (plan_.columns == ColumnStorage::kBatch)
        shift_.own = chunk_.window.first - plan_.first_value(batch * kVerticesPerBatch);
      append_batch(edges, batch);
      chunk_.batches.push_back({edges.end_column(batch), static_cast<std::uint32_t>(chunk_.runs.size())});
    }
    if (last == edges.batches()) append_batch(edges, last);
    return std::move(chunk_);
  }

 private:
  void make_room(std::span<const PlacedEdge> edges) {
    std::vector<std::size_t> edge_count(graph_.edge_pools().size(), 0), target_count(edge_count);
    for (const auto& [pool, edge] : edges) {
      ++edge_count[pool];
      target_count[pool] += Scatter::targets_of(graph_.edge_pools()[pool]->arity(edge));
    }
    for (std::uint32_t pool = 0; pool < edge_count.size(); ++pool) {
      if (edge_count[pool] == 0) continue;
      Scatter& scatter = chunk_.scatters[scatter_of(pool)];
      scatter.edges.reserve(edge_count[pool]);
      scatter.targets.reserve(target_count[pool]);
    }
  }

  void append_batch(const SortedEdges& edges, std::uint32_t batch) {
    begin_batch();
    for (const auto& [pool, edge] : edges.of_batches(batch, batch + 1)) {
      pace_.step(4);
      edge_blocks(*graph_.edge_pools()[pool], edge, active_.block, blocks_);
      append(pool, edge, blocks_);
    }
  }

  std::uint32_t scatter_of(std::uint32_t pool) {
    std::uint32_t& scatter = scatter_of_[pool];
    if (scatter == ActiveSet::kInactive) {
      scatter = static_cast<std::uint32_t>(chunk_.scatters.size());
      chunk_.scatters.push_back({pool, {}, {}, {}});
    }
    return scatter;
  }

  void begin_batch() { last_pool_ = ActiveSet::kInactive; }

  void append(std::uint32_t pool, std::uint32_t edge, const std::vector<std::uint32_t>& blocks) {
    const std::uint32_t scatter = scatter_of(pool);
    const auto position = static_cast<std::uint32_t>(chunk_.scatters[scatter].edges.size());
    if (std::exchange(last_pool_, pool) != pool) chunk_.runs.push_back({scatter, position, position});
    ++chunk_.runs.back().end;
    append_edge(*graph_.edge_pools()[pool], edge, blocks, plan_.structure, chunk_, shift_,
                chunk_.scatters[scatter]);
  }

  const Graph& graph_;
  const ActiveSet& active_;
  const Plan& plan_;
  Chunk chunk_;
  ValueShift shift_;
  std::vector<std::uint32_t> scatter_of_;
  PacedStop pace_;
  std::vector<std::uint32_t> blocks_;
  std::uint32_t last_pool_ = ActiveSet::kInactive;
};

/// The most values of H that the columns of one of the batches [first, last) have.
std::uint32_t largest_batch(const Plan& plan, std::uint32_t first, std::uint32_t last) {
  std::uint32_t largest = 0;
  for (std::uint32_t batch = first; batch < last; ++batch) {
    const std::uint32_t end = std::min((batch + 1) * kVerticesPerBatch, plan.eliminated_blocks);
    largest = std::max(largest, plan.first_value(end) - plan.first_value(batch * kVerticesPerBatch));
  }
  return largest;
}

}  // namespace

void add_chunks_by_owner(const Graph& graph, const ActiveSet& active, const StopToken& stop, Plan& plan) {
  PacedStop pace(stop);
  const std::vector<std::uint32_t> bounds = share_columns(graph, active, plan.workers, pace);
  for (std::size_t c = 0; c + 1 < bounds.size(); ++c) {
    Chunk chunk;
    chunk.first_column = bounds[c];
    chunk.last_column = bounds[c + 1];
    plan.chunks.push_back(ChunkBuilder(graph, active, plan, std::move(chunk), stop).build_from_all());
  }
}

void add_chunks_with_copies(const Graph& graph, const ActiveSet& active, int count, const StopToken& stop,
                            Plan& plan) {
  PacedStop pace(stop);
  const SortedEdges edges(graph, active, pace);
  const std::vector<std::uint32_t> bounds = edges.share_batches(count);
  auto window = static_cast<std::uint32_t>((bounds.size() - 1) * plan.shared_values());
  for (std::uint32_t c = 0; c + 1 < bounds.size(); ++c) {
    const bool is_last = bounds[c + 1] == edges.batches();
    Chunk chunk;
    chunk.first_column = bounds[c] * kVerticesPerBatch;
    chunk.last_column = is_last ? plan.structure.blocks() : bounds[c + 1] * kVerticesPerBatch;
    chunk.first_shared = active.eliminated_blocks;
    if (!is_last) chunk.copy = {(c + 1) * plan.shared_scalars(), (c + 1) * plan.shared_values()};
    if (plan.columns == ColumnStorage::kBatch)
      chunk.window = {window, largest_batch(plan, bounds[c], bounds[c + 1])};
    window += chunk.window.size;
    plan.chunks.push_back(ChunkBuilder(graph, active, plan, std::move(chunk), stop)
                              .build_from(edges, bounds[c], bounds[c + 1]));
  }
}

}  // namespace boxplus
