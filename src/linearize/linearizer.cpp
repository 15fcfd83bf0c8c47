// SPDX-License-Identifier: BSD-3-Clause
#include "linearize/linearizer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/all_finite.h"
#include "base/paced_stop.h"
#include "boxplus/base/large_pages.h"
#include "boxplus/base/parallel.h"
#include "linearize/accumulate.h"
#include "linearize/pairwise_sum.h"
#include "linearize/tile_memory.h"
#include "plan/fixed_directions.h"

namespace boxplus {
namespace {

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
    : graph_(&graph),
      plan_(&plan),
      edges_(graph),
      edge_chi2_(plan.edge_count),
      chunk_sums_(plan.chunks.size()) {
  const std::size_t copies = plan.eliminated_blocks > 0 ? plan.chunks.size() - 1 : 0;
  gradient_.resize(plan.scalars() + copies * plan.shared_scalars());
  std::size_t values = plan.structure.nonzero_values() - plan.first_stored_value();
  for (const Chunk& chunk : plan.chunks) values += chunk.window.size;
  values += copies * plan.shared_values();
  values_ = std::make_unique_for_overwrite<double[]>(values);
  detail::prefer_large_pages(values_.get(), values * sizeof(double));
  for (int worker = 0; worker < plan.workers; ++worker) {
    memory_.emplace_back(static_cast<std::size_t>(plan.max_tile_values),
                         static_cast<std::size_t>(plan.max_tile_rows), plan.max_dense_values);
  }
}

Linearizer::~Linearizer() = default;

/// Calls f for each chunk until it returns false: then, the token was raised. One worker runs all chunks of a
/// slice, in order.
void Linearizer::for_each_chunk(int slices, detail::FunctionRef<bool(const Chunk&, int, TileMemory&)> f) {
  stopped_ = false;
  const int threads = std::min(workers(), slices), chunks = static_cast<int>(plan_->chunks.size());
  detail::parallel_tasks(threads, [&](int worker) {
    for (int slice = slices * worker / threads; slice < slices * (worker + 1) / threads; ++slice) {
      for (int c = chunks * slice / slices; c < chunks * (slice + 1) / slices; ++c) {
        if (!f(plan_->chunks[c], slice, memory_[worker])) return void(stopped_ = true);
      }
    }
  });
}

void Linearizer::linearize(const LinearizeOptions& options, int slices, AfterBatch after_batch) {
  for_each_chunk(slices, [&](const Chunk& chunk, int slice, TileMemory& memory) {
    return linearize_chunk(chunk, memory, options, slice, after_batch);
  });
  if (stopped_) return;
  add_copies();
  for (const Chunk& chunk : plan_->chunks)
    leave_out_fixed(chunk.fixed, {values_.get(), values().size()}, gradient_);
}

/// The memory for the values of a batch whose first column is `first_column`.
double* Linearizer::batch_values(const Chunk& chunk, std::uint32_t first_column) const {
  const bool are_stored = plan_->columns == ColumnStorage::kAll;
  return values_.get() + (are_stored ? plan_->first_value(first_column) : chunk.window.first);
}

/// Linearizes the edges of a chunk. Returns false if the token was raised.
bool Linearizer::linearize_chunk(const Chunk& chunk, TileMemory& memory, const LinearizeOptions& options,
                                 int slice, AfterBatch after_batch) {
  PacedStop pace(stop_, kEdgesBetweenStops);
  if (!clear_unbatched(chunk, pace)) return false;
  std::uint32_t column = chunk.first_column, run = 0;
  for (const Chunk::Batch& batch : chunk.batches) {
    double* const values = batch_values(chunk, column);
    clear_columns(column, batch.end_column, values);
    if (!linearize_runs(chunk, run, batch.end_run, memory, options, pace)) return false;
    after_batch({slice, column, batch.end_column, values});
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
    return std::size_t{plan_->first_value(column)} - plan_->first_stored_value();
  };
  std::fill(gradient_.begin() + structure.offset[first],
            gradient_.begin() + structure.offset[chunk.last_column], 0.0);
  if (first < chunk.last_column && !clear_values(value_of(first), value_of(chunk.last_column), pace))
    return false;
  if (chunk.copy.in_gradient == 0) return true;
  std::fill_n(gradient_.begin() + structure.offset[chunk.first_shared] + chunk.copy.in_gradient,
              plan_->shared_scalars(), 0.0);
  const std::size_t copy = value_of(chunk.first_shared) + chunk.copy.in_values;
  return clear_values(copy, copy + plan_->shared_values(), pace);
}

bool Linearizer::clear_values(std::size_t begin, std::size_t end, PacedStop& pace) {
  for (; begin < end; begin += std::min(kValuesBetweenStops, end - begin)) {
    std::fill_n(values_.get() + begin, std::min(kValuesBetweenStops, end - begin), 0.0);
    if (pace.is_raised_after(kEdgesBetweenStops)) return false;
  }
  return true;
}

void Linearizer::clear_columns(std::uint32_t first, std::uint32_t last, double* values) {
  const std::vector<std::uint32_t>& offset = plan_->structure.offset;
  std::fill_n(values, plan_->first_value(last) - plan_->first_value(first), 0.0);
  std::fill(gradient_.begin() + offset[first], gradient_.begin() + offset[last], 0.0);
}

/// Linearizes the runs [first, last) of a chunk. Returns false if the token was raised.
bool Linearizer::linearize_runs(const Chunk& chunk, std::uint32_t first, std::uint32_t last,
                                TileMemory& memory, const LinearizeOptions& options, PacedStop& pace) {
  for (std::uint32_t k = first; k < last; ++k) {
    const Chunk::Run& run = chunk.runs[k];
    if (!edges_.add(chunk.scatters[run.scatter], run.begin, run.end, memory, options, pace,
                    {values_.get(), gradient_.data()}))
      return false;
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
    double* const values =
        values_.get() + (plan_->first_value(chunk.first_shared) - plan_->first_stored_value());
    for (std::uint32_t i = 0; i < plan_->shared_values(); ++i) values[i] += values[chunk.copy.in_values + i];
  }
}

void Linearizer::subtract_coupling(const LinearizeOptions& options, int slices, double* x,
                                   AfterBatch after_batch) {
  for_each_chunk(slices, [&](const Chunk& chunk, int slice, TileMemory& memory) {
    PacedStop pace(stop_, kEdgesBetweenStops);
    std::uint32_t column = chunk.first_column, run = 0;
    for (const Chunk::Batch& batch : chunk.batches) {
      for (; run < batch.end_run; ++run) {
        const auto subtract = [&](const PlacedTile& edges) {
          if (edges.dims.size() > 1) memory.products.subtract_coupling(edges, layout_of(chunk), x);
        };
        if (!multiply_run(chunk, chunk.runs[run], memory, options, pace, subtract)) return false;
      }
      after_batch({slice, column, batch.end_column, nullptr});
      column = batch.end_column;
    }
    return true;
  });
}

double Linearizer::curvature(const LinearizeOptions& options, const double* d) {
  std::fill(chunk_sums_.begin(), chunk_sums_.end(), 0.0);
  for_each_chunk(static_cast<int>(chunk_sums_.size()), [&](const Chunk& chunk, int c, TileMemory& memory) {
    PacedStop pace(stop_, kEdgesBetweenStops);
    double& sum = chunk_sums_[c];
    return std::all_of(chunk.runs.begin(), chunk.runs.end(), [&](const Chunk::Run& run) {
      return multiply_run(chunk, run, memory, options, pace, [&](const PlacedTile& edges) {
        sum += memory.products.curvature(edges, layout_of(chunk), d);
      });
    });
  });
  return stopped_ ? std::numeric_limits<double>::quiet_NaN() : pairwise_sum(chunk_sums_);
}

/// Linearizes the edges of a run, and calls f for each tile, whose size suits JacobianProducts. Returns false
/// if the token was raised.
bool Linearizer::multiply_run(const Chunk& chunk, const Chunk::Run& run, TileMemory& memory,
                              const LinearizeOptions& options, PacedStop& pace,
                              detail::FunctionRef<void(const PlacedTile&)> f) {
  const Scatter& scatter = chunk.scatters[run.scatter];
  const bool in_lanes = fits_kernels(*graph_->edge_pools()[scatter.pool], scatter.edges[run.begin]);
  return edges_.for_each_tile(scatter, run.begin, run.end, memory, options, in_lanes, pace, f);
}

/// The layout of vectors for the gradient targets of a chunk.
VectorLayout Linearizer::layout_of(const Chunk& chunk) const {
  return {plan_->structure.offset[plan_->eliminated_blocks], chunk.copy.in_gradient};
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

}  // namespace boxplus
