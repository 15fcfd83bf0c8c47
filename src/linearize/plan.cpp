// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/linearize/plan.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <string>
#include <utility>

#include "base/paced_stop.h"
#include "linear/automatic/physical_memory.h"
#include "linearize/accumulate.h"
#include "linearize/active_set.h"
#include "linearize/edge_targets.h"
#include "linearize/fixed_directions.h"

namespace boxplus {
namespace {

/// The least predicted work of a worker. With less work, an additional worker saves no time.
constexpr double kMinWorkerNanoseconds = 120e3;

/// The predicted time to linearize an edge, per entry of its Jacobian.
double nanoseconds_per_entry(detail::JacobianSource source) {
  switch (source) {
    case detail::JacobianSource::kAnalytic:
      return 2.5;
    case detail::JacobianSource::kAutomatic:
      return 15;
    default:
      return 50;
  }
}

double predicted_nanoseconds(const Graph& graph, const Plan& plan, PacedStop& pace) {
  double total = 0;
  for (const EdgeList& list : plan.edges) {
    const detail::EdgePool& pool = *graph.edge_pools()[list.pool];
    const double per_entry = nanoseconds_per_entry(pool.jacobian_source());
    if (pool.uniform_shape() && !list.edges.empty()) {
      const detail::EdgeShape shape = pool.shape(list.edges.front());
      total += per_entry * shape.rows * shape.cols * static_cast<double>(list.edges.size());
      continue;
    }
    for (const std::uint32_t edge : list.edges) {
      pace.step();
      const detail::EdgeShape shape = pool.shape(edge);
      total += per_entry * shape.rows * shape.cols;
    }
  }
  return total;
}

std::size_t count_active_edges(const ActiveSet& active) {
  std::size_t count = 0;
  for (const auto& edges : active.edges) count += edges.size();
  return count;
}

template <class F>
void for_each_active_edge(const Graph& graph, const ActiveSet& active, PacedStop& pace, F&& f) {
  std::vector<std::uint32_t> blocks;
  for (std::uint32_t p = 0; p < active.edges.size(); ++p) {
    for (std::uint32_t edge : active.edges[p]) {
      pace.step();
      edge_blocks(*graph.edge_pools()[p], edge, active.block, blocks);
      f(p, edge, blocks);
    }
  }
}

void check_elimination(const Graph& graph, const ActiveSet& active,
                       const std::vector<std::uint32_t>& blocks) {
  std::uint32_t other = ActiveSet::kInactive;
  for (std::uint32_t block : blocks) {
    if (block >= active.eliminated_blocks) continue;
    if (other != ActiveSet::kInactive) {
      throw InvalidArgument("vertices " + std::to_string(graph.id(active.block_vertex[other])) + " and " +
                            std::to_string(graph.id(active.block_vertex[block])) +
                            " are both marked as eliminated, but an edge joins them");
    }
    other = block;
  }
}

BlockStructure hessian_structure(const Graph& graph, const ActiveSet& active, const StopToken& stop) {
  PacedStop pace(stop);
  std::vector<std::uint32_t> dims;
  dims.reserve(active.block_vertex.size());
  for (const VertexRef& v : active.block_vertex) {
    pace.step();
    dims.push_back(static_cast<std::uint32_t>(graph.vertex_pools()[v.pool]->tangent_dim(v.slot)));
  }
  std::vector<BlockCoordinate> pairs;
  pairs.reserve(count_active_edges(active));
  for_each_active_edge(
      graph, active, pace, [&](std::uint32_t, std::uint32_t, const std::vector<std::uint32_t>& blocks) {
        check_elimination(graph, active, blocks);
        for (std::size_t i = 0; i < blocks.size(); ++i) {
          for (std::size_t j = 0; j < i; ++j) {
            if (blocks[i] == ActiveSet::kInactive || blocks[j] == ActiveSet::kInactive) continue;
            pairs.push_back({std::max(blocks[i], blocks[j]), std::min(blocks[i], blocks[j])});
          }
        }
      });
  BlockStructure structure = make_block_structure(dims, pairs, stop);
  if (structure.nonzero_values() >= Scatter::kTransposed) {
    throw InvalidArgument("the problem is too large: H has more than 2^31 values");
  }
  return structure;
}

void list_vertices(const ActiveSet& active, Plan& plan, PacedStop& pace) {
  std::vector<std::uint32_t> list_of(active.block.size(), ActiveSet::kInactive);
  for (std::uint32_t block = 0; block < active.block_vertex.size(); ++block) {
    pace.step();
    const VertexRef& vertex = active.block_vertex[block];
    if (list_of[vertex.pool] == ActiveSet::kInactive) {
      list_of[vertex.pool] = static_cast<std::uint32_t>(plan.vertices.size());
      plan.vertices.push_back({vertex.pool, {}, {}});
    }
    VertexList& list = plan.vertices[list_of[vertex.pool]];
    list.slots.push_back(vertex.slot);
    list.offsets.push_back(plan.structure.offset[block]);
  }
}

void list_edges(const Graph& graph, ActiveSet& active, Plan& plan, PacedStop& pace) {
  for (std::uint32_t p = 0; p < active.edges.size(); ++p) {
    if (active.edges[p].empty()) continue;
    const detail::EdgePool& pool = *graph.edge_pools()[p];
    for (std::uint32_t edge : active.edges[p]) {
      pace.step();
      const detail::EdgeShape shape = pool.shape(edge);
      const int capacity = pool.uniform_shape() ? tile_capacity(shape) : 1;
      plan.max_tile_values = std::max(plan.max_tile_values, capacity * std::max(1, shape.rows) * shape.cols);
      plan.max_tile_rows = std::max(plan.max_tile_rows, capacity * shape.rows);
      plan.max_dense_values = std::max(plan.max_dense_values, dense_scratch(shape.rows, shape.cols));
      if (pool.uniform_shape()) break;
    }
    plan.edges.push_back({p, plan.edge_count, active.edges[p]});
    plan.edge_count += static_cast<std::uint32_t>(active.edges[p].size());
  }
}

void place_gauge(const ActiveSet& active, Plan& plan) {
  const auto block_of = [&](const VertexRef& vertex) { return active.block[vertex.pool][vertex.slot]; };
  plan.held = active.gauge.held;
  plan.freedoms = active.gauge.freedoms;
  for (const auto& [vertex, component] : active.gauge.held_directions) {
    plan.held_scalars.push_back(plan.structure.offset[block_of(vertex)] +
                                static_cast<std::uint32_t>(component));
  }
  for (const VertexRef& vertex : active.gauge.loose) plan.loose_blocks.push_back(block_of(vertex));
}

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

/// The number of chunks if vertices are eliminated. It does not depend on the number of workers, and is so
/// small that the copies of the shared columns are small.
int count_chunks(const Plan& plan, double predicted_nanoseconds) {
  constexpr double kMostChunks = 8, kLargestCopy = 1.0 / 16;
  const double shared = plan.shared_values(), all = plan.structure.nonzero_values();
  const double room = std::min(kLargestCopy * all, Scatter::kTransposed - all);
  const double most = std::min(kMostChunks, 1 + room / std::max(1.0, shared));
  return std::max(1, static_cast<int>(std::min(most, predicted_nanoseconds / kMinWorkerNanoseconds)));
}

/// Decides whether the columns of eliminated vertices are stored. Recomputing them costs the Jacobians once
/// more, but storing them costs the time to write them to memory and to read them again.
ColumnStorage choose_column_storage(const Graph& graph, const Plan& plan, ColumnStorage requested,
                                    double predicted_nanoseconds) {
  constexpr double kJacobianShare = 0.4, kNanosecondsPerByte = 0.2, kCacheBytes = 1 << 20;
  constexpr double kBytesOfAnyMachine = 1 << 28, kMemoryShare = 0.25;
  const auto has_fixed_directions = [&](VertexRef vertex) {
    return !graph.vertex_pools()[vertex.pool]->fixed_directions(vertex.slot).empty();
  };
  const auto first_kept = plan.block_vertex.begin() + plan.eliminated_blocks;
  if (plan.eliminated_blocks == 0 || plan.shared_scalars() == 0 ||
      std::any_of(plan.block_vertex.begin(), first_kept, has_fixed_directions))
    return ColumnStorage::kAll;
  if (requested != ColumnStorage::kAutomatic) return requested;
  const double bytes = sizeof(double) * std::size_t{plan.eliminated_values()};
  if (bytes > kCacheBytes && kJacobianShare * predicted_nanoseconds < kNanosecondsPerByte * bytes)
    return ColumnStorage::kBatch;
  if (bytes <= kBytesOfAnyMachine) return ColumnStorage::kAll;
  const auto memory = static_cast<double>(physical_memory());
  return memory > 0 && bytes > kMemoryShare * memory ? ColumnStorage::kBatch : ColumnStorage::kAll;
}

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

/// The chunks if no vertex is eliminated.
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

/// The chunks if vertices are eliminated.
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

}  // namespace

int tile_capacity(const detail::EdgeShape& shape) {
  constexpr int kTileBytes = 16 * 1024;
  const int bytes = std::max(1, shape.rows * (shape.cols + 1)) * static_cast<int>(sizeof(double));
  const int capacity = std::clamp(kTileBytes / bytes, 1, detail::EdgeTile::kCapacity);
  return capacity < detail::EdgeTile::kLanes ? capacity
                                             : capacity / detail::EdgeTile::kLanes * detail::EdgeTile::kLanes;
}

Plan make_plan(const Graph& graph, const PlanRequest& request) {
  ActiveSet active = find_active_set(graph, request);
  Plan plan;
  plan.block_vertex = active.block_vertex;
  plan.eliminated_blocks = active.eliminated_blocks;
  PacedStop pace(request.stop);
  plan.structure = hessian_structure(graph, active, request.stop);
  place_gauge(active, plan);
  list_vertices(active, plan, pace);
  list_edges(graph, active, plan, pace);
  const double predicted = predicted_nanoseconds(graph, plan, pace);
  const double worth = std::min(predicted / kMinWorkerNanoseconds, 1.0 * request.threads);
  plan.workers = std::max(1, static_cast<int>(worth));
  plan.columns = choose_column_storage(graph, plan, request.columns, predicted);
  if (plan.eliminated_blocks > 0) {
    add_chunks_with_copies(graph, active, count_chunks(plan, predicted), request.stop, plan);
  } else {
    add_chunks_by_owner(graph, active, request.stop, plan);
  }
  plan.workers = std::min(plan.workers, static_cast<int>(plan.chunks.size()));
  list_fixed_directions(graph, plan);
  return plan;
}

}  // namespace boxplus
