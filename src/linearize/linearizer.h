// SPDX-License-Identifier: BSD-3-Clause
// Computes H and the gradient of F(x) = Σ ρ(eᵀΩe) at the current estimates, tile by tile.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "boxplus/base/function_ref.h"
#include "linearize/edge_linearizer.h"
#include "plan/plan.h"

namespace boxplus {

struct VectorLayout;

/// Computes H and the gradient in each iteration, and stores them. Allocates only in the constructor.
///
/// H = Σ ρ′ JᵀΩJ and gradient = Σ ρ′ JᵀΩe, with ρ′ clamped to ≥ 0. Therefore, F(x ⊞ δ) ≈ F + 2 gradientᵀδ +
/// δᵀHδ, and the Gauss-Newton step solves H δ = −gradient. The results have the same bits for any number of
/// workers.
class Linearizer {
 public:
  Linearizer(const Graph& graph, const Plan& plan);
  ~Linearizer();

  void linearize(const LinearizeOptions& options) {
    linearize(options, static_cast<int>(plan_->chunks.size()), [](const Batch&) {});
  }
  /// A batch of eliminated vertices, whose columns of H are [first, last). `values` is the address of the
  /// first value of these columns. A slice is a range of chunks. One worker runs all chunks of a slice, in
  /// order.
  struct Batch {
    int slice;
    std::uint32_t first, last;
    const double* values;
  };
  using AfterBatch = detail::FunctionRef<void(const Batch&)>;
  /// The same. Divides the chunks into `slices` ranges. Calls after_batch() when the columns of a batch are
  /// complete in H and in the gradient, while they are in the cache. With ColumnStorage::kBatch, their values
  /// are then lost.
  void linearize(const LinearizeOptions& options, int slices, AfterBatch after_batch);
  /// Let W be the rows of kept vertices in the columns of eliminated vertices. Sets x_e −= Wᵀ x_k, for the
  /// parts x_e and x_k of x that belong to eliminated and to kept vertices. Computes Jacobians instead of
  /// reading H. Calls after_batch() when the part of x of each batch is complete; values are null.
  void subtract_coupling(const LinearizeOptions& options, int slices, double* x, AfterBatch after_batch);
  /// dᵀHd. Computes Jacobians instead of reading H.
  double curvature(const LinearizeOptions& options, const double* d);
  /// Σ ρ(eᵀΩe) over the active, enabled edges. Not finite if the term of an edge is not finite.
  double chi2();
  /// When the token is raised, all functions that compute end soon. Their results are then not usable; those
  /// of chi2() and curvature() are NaN. stopped() is true until the next call.
  void set_stop(const StopToken& stop) { stop_ = stop; }
  bool stopped() const { return stopped_; }
  /// The values of H, beginning with Plan::first_stored_value(). Not initialized before the first
  /// linearize().
  std::span<const double> values() const {
    return {values_.get(), plan_->structure.nonzero_values() - plan_->first_stored_value()};
  }
  std::span<const double> gradient() const { return std::span(gradient_).first(plan_->scalars()); }
  int workers() const { return plan_->workers; }

 private:
  void for_each_chunk(int slices, detail::FunctionRef<bool(const Chunk&, int slice, TileMemory&)> f);
  bool linearize_chunk(const Chunk& chunk, TileMemory& memory, const LinearizeOptions& options, int slice,
                       AfterBatch after_batch);
  double* batch_values(const Chunk& chunk, std::uint32_t first_column) const;
  bool clear_unbatched(const Chunk& chunk, PacedStop& pace);
  bool clear_values(std::size_t begin, std::size_t end, PacedStop& pace);
  void clear_columns(std::uint32_t first, std::uint32_t last, double* values);
  bool linearize_runs(const Chunk& chunk, std::uint32_t first, std::uint32_t last, TileMemory& memory,
                      const LinearizeOptions& options, PacedStop& pace);
  void add_copies();
  bool multiply_run(const Chunk& chunk, const Chunk::Run& run, TileMemory& memory,
                    const LinearizeOptions& options, PacedStop& pace,
                    detail::FunctionRef<void(const PlacedTile&)> f);
  VectorLayout layout_of(const Chunk& chunk) const;
  void evaluate_share(int worker, int workers);

  const Graph* graph_;
  const Plan* plan_;
  EdgeLinearizer edges_;
  StopToken stop_;
  std::atomic<bool> stopped_ = false;
  std::unique_ptr<double[]> values_;  // not initialized, so that the workers are the first to touch its pages
  std::vector<double> gradient_, edge_chi2_;  // values_ and gradient_ end with the copies of the chunks
  std::vector<double> chunk_sums_;            // of curvature()
  std::vector<TileMemory> memory_;
};

}  // namespace boxplus
