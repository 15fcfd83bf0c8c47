// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/linearize/plan.h"

#include <algorithm>
#include <numeric>
#include <string>

#include "base/paced_stop.h"
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

/// Builds the scatter map of one chunk.
class ChunkBuilder {
 public:
  ChunkBuilder(const Graph& graph, const ActiveSet& active, const BlockStructure& structure,
               std::uint32_t first, std::uint32_t last, const StopToken& stop)
      : graph_(graph), active_(active), structure_(structure), pace_(stop) {
    chunk_.first_column = first;
    chunk_.last_column = last;
  }

  Chunk build() {
    const std::vector<Entry> entries = sorted_entries();
    std::vector<std::uint32_t> scatter_of(graph_.edge_pools().size(), ActiveSet::kInactive);
    for (std::size_t k = 0; k < entries.size(); ++k) {
      pace_.step(4);
      const Entry& entry = entries[k];
      std::uint32_t& scatter = scatter_of[entry.pool];
      if (scatter == ActiveSet::kInactive) {
        scatter = static_cast<std::uint32_t>(chunk_.scatters.size());
        chunk_.scatters.push_back({entry.pool, {}, {}, {}});
      }
      const auto position = static_cast<std::uint32_t>(chunk_.scatters[scatter].edges.size());
      if (k == 0 || entries[k - 1].pool != entry.pool) chunk_.runs.push_back({scatter, position, position});
      ++chunk_.runs.back().end;
      const detail::EdgePool& pool = *graph_.edge_pools()[entry.pool];
      edge_blocks(pool, entry.edge, active_.block, blocks_);
      append_edge(pool, entry.edge, blocks_, structure_, chunk_, chunk_.scatters[scatter]);
    }
    return std::move(chunk_);
  }

 private:
  struct Entry {
    std::uint32_t batch, pool, edge;
  };

  /// The edges that touch the chunk: batch by batch of eliminated vertices, then the edges that touch none.
  /// Within a batch, they are sorted by pool and slot. So tiles are full, and the values that a batch changes
  /// stay in the cache.
  std::vector<Entry> sorted_entries() {
    constexpr std::uint32_t kVerticesPerBatch = 64;
    const std::uint32_t batches = (active_.eliminated_blocks + kVerticesPerBatch - 1) / kVerticesPerBatch;
    std::vector<Entry> entries;
    std::vector<std::uint32_t> next(batches + 2, 0);
    for_each_active_edge(
        graph_, active_, pace_, [&](std::uint32_t pool, std::uint32_t edge, const auto& blocks) {
          if (!touches(chunk_, blocks)) return;
          const std::uint32_t first = *std::min_element(blocks.begin(), blocks.end());
          const std::uint32_t batch = first < active_.eliminated_blocks ? first / kVerticesPerBatch : batches;
          entries.push_back({batch, pool, edge});
          ++next[batch + 1];
        });
    if (batches == 0) return entries;
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<Entry> sorted(entries.size());
    for (const Entry& entry : entries) {
      pace_.step();
      sorted[next[entry.batch]++] = entry;
    }
    return sorted;
  }

  const Graph& graph_;
  const ActiveSet& active_;
  const BlockStructure& structure_;
  PacedStop pace_;
  Chunk chunk_;
  std::vector<std::uint32_t> blocks_;
};

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
  const int workers = std::max(1, static_cast<int>(worth));
  const std::vector<std::uint32_t> bounds = share_columns(graph, active, workers, pace);
  for (std::size_t c = 0; c + 1 < bounds.size(); ++c) {
    ChunkBuilder builder(graph, active, plan.structure, bounds[c], bounds[c + 1], request.stop);
    plan.chunks.push_back(builder.build());
  }
  list_fixed_directions(graph, plan);
  return plan;
}

}  // namespace boxplus
