// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <numeric>
#include <span>
#include <string>
#include <utility>

#include "base/paced_stop.h"
#include "plan/active_set.h"
#include "plan/chunks.h"
#include "plan/dense_scratch.h"
#include "plan/fixed_directions.h"
#include "plan/plan.h"
#include "platform/memory.h"

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
  for (const VertexRef& vertex : active.gauge.loose) plan.undetermined_blocks.push_back(block_of(vertex));
}

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

}  // namespace

int tile_capacity(const detail::EdgeShape& shape) {
  constexpr int kTileBytes = 16 * 1024;
  const int bytes = std::max(1, shape.rows * (shape.cols + 1)) * static_cast<int>(sizeof(double));
  const int capacity = std::clamp(kTileBytes / bytes, 1, detail::EdgeTile::kCapacity);
  return capacity < detail::EdgeTile::kLanes ? capacity
                                             : capacity / detail::EdgeTile::kLanes * detail::EdgeTile::kLanes;
}

Plan make_plan(const Graph& graph, const PlanRequest& request) {
  return make_plan(graph, request, GaugeBounds::kApply);
}

Plan make_plan(const Graph& graph, const PlanRequest& request, GaugeBounds bounds) {
  ActiveSet active = find_active_set(graph, request, bounds);
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
