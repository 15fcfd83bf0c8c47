// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/linearize/linearizer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/all_finite.h"
#include "base/paced_stop.h"
#include "boxplus/base/large_pages.h"
#include "boxplus/base/parallel.h"
#include "linearize/accumulate.h"
#include "linearize/fixed_directions.h"
#include "linearize/pairwise_sum.h"
#include "linearize/tile_memory.h"

namespace boxplus {
namespace {

/// Lists the tangent sizes of an edge's vertices.
void vertex_dims(const Graph& graph, const detail::EdgePool& pool, std::uint32_t edge,
                 std::vector<int>& dims) {
  dims.clear();
  const auto slots = pool.vertex_slots(edge);
  for (std::size_t i = 0; i < slots.size(); ++i) {
    dims.push_back(graph.vertex_pools()[pool.vertex_pool(edge, static_cast<int>(i))]->tangent_dim(slots[i]));
  }
}

/// The number of edges between two checks of the stop token. It is reasonable for edges that take between 1
/// µs and 100 µs. kValuesBetweenStops is the number of values of H that are cleared in about the same time.
constexpr std::uint32_t kEdgesBetweenStops = detail::EdgeTile::kCapacity;
constexpr std::size_t kValuesBetweenStops = 1u << 15;

/// Computes ρ(eᵀΩe) of the listed edges. Disabled edges get 0. Keeps values that are not finite, because a
/// robust kernel may hide them.
void evaluate(const detail::EdgePool& pool, std::span<const std::uint32_t> edges, double* out) {
  pool.chi2(edges, out);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    if (!pool.enabled(edges[k])) out[k] = 0;
  }
  if (!pool.has_kernels()) return;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const RobustKernel* kernel = pool.enabled(edges[k]) ? pool.kernel(edges[k]) : nullptr;
    if (kernel && std::isfinite(out[k])) out[k] = (*kernel)(out[k]).value;
  }
}

}  // namespace

Linearizer::Linearizer(const Graph& graph, const Plan& plan)
    : graph_(&graph), plan_(&plan), edge_chi2_(plan.edge_count) {
  const std::size_t copies = plan.eliminated_blocks > 0 ? plan.chunks.size() - 1 : 0;
  gradient_.resize(plan.scalars() + copies * plan.shared_scalars());
  allocate_values(plan.structure.nonzero_values() + copies * plan.shared_values());
  for (int worker = 0; worker < plan.workers; ++worker) {
    memory_.emplace_back(static_cast<std::size_t>(plan.max_tile_values),
                         static_cast<std::size_t>(plan.max_tile_rows), plan.max_dense_values);
  }
}

Linearizer::~Linearizer() = default;

void Linearizer::allocate_values(std::size_t room) {
  values_.reset();
  values_ = std::make_unique_for_overwrite<double[]>(room);
  values_room_ = room;
  detail::prefer_large_pages(values_.get(), room * sizeof(double));
}

void Linearizer::extend() {
  const std::size_t values = plan_->structure.nonzero_values();
  if (values > values_room_) allocate_values(values + values / 4);
  gradient_.resize(plan_->scalars());
  edge_chi2_.resize(plan_->edge_count);
}

void Linearizer::linearize(const LinearizeOptions& options, int groups, AfterBatch after_batch) {
  stopped_ = false;
  const int threads = std::min(workers(), groups), chunks = static_cast<int>(plan_->chunks.size());
  detail::parallel_tasks(threads, [&](int worker) {
    for (int group = groups * worker / threads; group < groups * (worker + 1) / threads; ++group) {
      const auto done = [&](std::uint32_t first, std::uint32_t last) { after_batch(group, first, last); };
      for (int c = chunks * group / groups; c < chunks * (group + 1) / groups; ++c) {
        const Chunk& chunk = plan_->chunks[static_cast<std::size_t>(c)];
        if (!linearize_chunk(chunk, memory_[static_cast<std::size_t>(worker)], options, done))
          return void(stopped_ = true);
      }
    }
  });
  if (stopped_) return;
  add_copies();
  for (const Chunk& chunk : plan_->chunks)
    leave_out_fixed(chunk.fixed, {values_.get(), plan_->structure.nonzero_values()}, gradient_);
}

/// Linearizes the edges of a chunk. Returns false if the token was raised.
bool Linearizer::linearize_chunk(const Chunk& chunk, TileMemory& memory, const LinearizeOptions& options,
                                 detail::FunctionRef<void(std::uint32_t, std::uint32_t)> after_batch) {
  PacedStop pace(stop_, kEdgesBetweenStops);
  if (!clear_unbatched(chunk, pace)) return false;
  std::uint32_t column = chunk.first_column, run = 0;
  for (const Chunk::Batch& batch : chunk.batches) {
    clear_columns(column, batch.end_column);
    if (!linearize_runs(chunk, run, batch.end_run, memory, options, pace)) return false;
    after_batch(column, batch.end_column);
    column = batch.end_column;
    run = batch.end_run;
  }
  return linearize_runs(chunk, run, static_cast<std::uint32_t>(chunk.runs.size()), memory, options, pace);
}

/// Clears the columns of a chunk that belong to no batch, and its copies of the shared columns. Returns false
/// if the token was raised.
bool Linearizer::clear_unbatched(const Chunk& chunk, PacedStop& pace) {
  const BlockStructure& structure = plan_->structure;
  const std::uint32_t first = chunk.batches.empty() ? chunk.first_column : chunk.batches.back().end_column;
  const auto value_of = [&](std::uint32_t column) {
    return structure.value_start[structure.column_start[column]];
  };
  std::fill(gradient_.begin() + structure.offset[first],
            gradient_.begin() + structure.offset[chunk.last_column], 0.0);
  if (!clear_values(value_of(first), value_of(chunk.last_column), pace)) return false;
  if (chunk.copy.in_gradient == 0) return true;
  std::fill_n(gradient_.begin() + structure.offset[chunk.first_shared] + chunk.copy.in_gradient,
              plan_->shared_scalars(), 0.0);
  const std::size_t copy = value_of(chunk.first_shared) + std::size_t{chunk.copy.in_values};
  return clear_values(copy, copy + plan_->shared_values(), pace);
}

bool Linearizer::clear_values(std::size_t begin, std::size_t end, PacedStop& pace) {
  for (; begin < end; begin += std::min(kValuesBetweenStops, end - begin)) {
    std::fill_n(values_.get() + begin, std::min(kValuesBetweenStops, end - begin), 0.0);
    if (pace.is_raised_after(kEdgesBetweenStops)) return false;
  }
  return true;
}

void Linearizer::clear_columns(std::uint32_t first, std::uint32_t last) {
  const BlockStructure& structure = plan_->structure;
  std::fill(values_.get() + structure.value_start[structure.column_start[first]],
            values_.get() + structure.value_start[structure.column_start[last]], 0.0);
  std::fill(gradient_.begin() + structure.offset[first], gradient_.begin() + structure.offset[last], 0.0);
}

/// Linearizes the runs [first, last) of a chunk. Returns false if the token was raised.
bool Linearizer::linearize_runs(const Chunk& chunk, std::uint32_t first, std::uint32_t last,
                                TileMemory& memory, const LinearizeOptions& options, PacedStop& pace) {
  for (std::uint32_t k = first; k < last; ++k) {
    const Chunk::Run& run = chunk.runs[k];
    if (!linearize_run(chunk.scatters[run.scatter], run, memory, options, pace)) return false;
  }
  return true;
}

/// Adds the copies of the shared columns to H and to the gradient, in the order of the chunks.
void Linearizer::add_copies() {
  const BlockStructure& structure = plan_->structure;
  for (const Chunk& chunk : plan_->chunks) {
    if (chunk.copy.in_gradient == 0) continue;
    double* const gradient = gradient_.data() + structure.offset[chunk.first_shared];
    for (std::uint32_t i = 0; i < plan_->shared_scalars(); ++i)
      gradient[i] += gradient[chunk.copy.in_gradient + i];
    double* const values = values_.get() + structure.value_start[structure.column_start[chunk.first_shared]];
    for (std::uint32_t i = 0; i < plan_->shared_values(); ++i) values[i] += values[chunk.copy.in_values + i];
  }
}

/// Linearizes the edges of a run, and adds them to H and to the gradient. Returns false if the token was
/// raised.
bool Linearizer::linearize_run(const Scatter& scatter, const Chunk::Run& run, TileMemory& memory,
                               const LinearizeOptions& options, PacedStop& pace) {
  const detail::EdgePool& pool = *graph_->edge_pools()[scatter.pool];
  vertex_dims(*graph_, pool, scatter.edges[run.begin], memory.dims);
  const bool uniform = pool.uniform_shape();
  const detail::EdgeShape shape = pool.shape(scatter.edges[run.begin]);
  const std::size_t capacity = uniform ? static_cast<std::size_t>(tile_capacity(shape)) : 1;
  const bool by_tiles = capacity >= detail::EdgeTile::kLanes && !options.triggs_correction &&
                        memory.adder.choose(shape.rows, memory.dims);
  detail::EdgeTile tile;
  tile.error = memory.error.data();
  tile.jacobian = memory.jacobian.data();
  for (std::uint32_t next = run.begin; next < run.end;) {
    const auto edges = memory.gather(pool, scatter, next, run.end, capacity);
    if (edges.empty()) continue;
    if (pace.is_raised_after(static_cast<std::int64_t>(edges.size()))) return false;
    tile.in_lanes = by_tiles && memory.adder.takes_lanes();
    pool.linearize(edges, tile, options.numeric_jacobians);
    if (by_tiles) {
      memory.adder.add(pool, edges, tile, memory.targets, values_.get(), gradient_.data());
    } else {
      if (!uniform) vertex_dims(*graph_, pool, edges[0], memory.dims);
      add_one_by_one(pool, edges, tile, memory, options.triggs_correction);
    }
  }
  return true;
}

void Linearizer::add_one_by_one(const detail::EdgePool& pool, std::span<const std::uint32_t> edges,
                                const detail::EdgeTile& tile, TileMemory& memory, bool triggs_correction) {
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const double* error = tile.error + k * static_cast<std::size_t>(tile.rows);
    const double* jacobian = tile.jacobian + k * static_cast<std::size_t>(tile.rows * tile.cols);
    const detail::InformationView omega = pool.information(edges[k], tile.rows);
    const RobustKernel* kernel = pool.kernel(edges[k]);
    const EdgeWeight weight =
        kernel ? edge_weight(kernel, omega.squared_norm(error), triggs_correction) : EdgeWeight{};
    accumulate({tile.rows, tile.cols, memory.dims, error, jacobian}, omega, weight, memory.targets[k],
               values_.get(), gradient_.data(), memory.weighted.data(), memory.weighted_error.data(),
               memory.dense.data());
  }
}

double Linearizer::chi2() {
  stopped_ = false;
  const int count = workers();
  detail::parallel_tasks(count, [&](int worker) { evaluate_share(worker, count); });
  return stopped_ ? std::numeric_limits<double>::quiet_NaN() : pairwise_sum(edge_chi2_);
}

/// Evaluates one worker's share of the active edges. All workers get equal shares.
void Linearizer::evaluate_share(int worker, int workers) {
  const auto bound = [&](int w) {
    return static_cast<std::uint32_t>(std::uint64_t{plan_->edge_count} * static_cast<std::uint64_t>(w) /
                                      static_cast<std::uint64_t>(workers));
  };
  const std::uint32_t begin = bound(worker), end = bound(worker + 1);
  for (const EdgeList& list : plan_->edges) {
    const auto size = static_cast<std::uint32_t>(list.edges.size());
    const std::uint32_t from = std::clamp(begin, list.first, list.first + size);
    const std::uint32_t to = std::clamp(end, list.first, list.first + size);
    if (from == to) continue;
    const detail::EdgePool& pool = *graph_->edge_pools()[list.pool];
    for (std::uint32_t first = from; first < to;) {
      const std::uint32_t count = std::min(kEdgesBetweenStops, to - first);
      if (stop_.raised()) return void(stopped_ = true);
      evaluate(pool, std::span(list.edges).subspan(first - list.first, count), edge_chi2_.data() + first);
      first += count;
    }
  }
}

std::optional<EdgeRef> Linearizer::find_non_finite_error() const {
  for (const EdgeList& list : plan_->edges) {
    const detail::EdgePool& pool = *graph_->edge_pools()[list.pool];
    for (std::size_t k = 0; k < list.edges.size(); ++k) {
      if (std::isfinite(edge_chi2_[list.first + k])) continue;
      return EdgeRef{list.pool, list.edges[k], pool.generation(list.edges[k])};
    }
  }
  return std::nullopt;
}

std::optional<EdgeRef> Linearizer::find_non_finite_jacobian(const LinearizeOptions& options) const {
  for (const EdgeList& list : plan_->edges) {
    const detail::EdgePool& pool = *graph_->edge_pools()[list.pool];
    for (const std::uint32_t edge : list.edges) {
      if (!pool.enabled(edge)) continue;
      const detail::EdgeShape shape = pool.shape(edge);
      std::vector<double> error(static_cast<std::size_t>(shape.rows));
      std::vector<double> jacobian(static_cast<std::size_t>(shape.rows * shape.cols));
      detail::EdgeTile tile;
      tile.error = error.data();
      tile.jacobian = jacobian.data();
      pool.linearize(std::span(&edge, 1), tile, options.numeric_jacobians);
      const double e2 = pool.information(edge, shape.rows).squared_norm(error.data());
      const EdgeWeight weight = edge_weight(pool.kernel(edge), e2, options.triggs_correction);
      const bool is_finite = all_finite(jacobian) && all_finite(error) && std::isfinite(weight.first) &&
                             std::isfinite(weight.second);
      if (!is_finite) return EdgeRef{list.pool, edge, pool.generation(edge)};
    }
  }
  return std::nullopt;
}

}  // namespace boxplus
