// SPDX-License-Identifier: BSD-3-Clause
// The active edges of ready-made types (see core/edge_kind.h), which are evaluated without virtual calls and
// added to H by kernels of the engine.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "boxplus/base/function_ref.h"
#include "engine/batch_pass.h"
#include "engine/hessian_places.h"
#include "g2o/core/optimizable_graph.h"

namespace g2o {
namespace internal {

class BatchDivision;
class BatchPart;
struct EdgeTile;

/// Each edge belongs to one of at most eight parts. Each vertex also belongs to a part. An edge belongs to
/// the same part as its owner, which is its marginalized vertex, or the vertex that the edges use last.
/// Contributions to other vertices that belong to other parts are added to sums of the part. They are added
/// to H after all parts. The number of parts does not depend on the number of threads, so sums have the same
/// order for any number of threads.
class EdgeBatches {
 public:
  using Edge = OptimizableGraph::Edge;
  using Edges = OptimizableGraph::EdgeContainer;

  EdgeBatches();
  EdgeBatches(const EdgeBatches&) = delete;
  EdgeBatches& operator=(const EdgeBatches&) = delete;
  ~EdgeBatches();

  /// Takes the edges that can be evaluated in batches, and appends all other edges to `others`. `vertices` is
  /// the number of Hessian indices.
  void take(const Edges& edges, int vertices, Edges& others);
  bool empty() const { return parts_.empty(); }

  void for_each(boxplus::detail::FunctionRef<void(Edge&)> f) const;

  BatchPass compute_errors();

  /// Finds the places of all edges in H. Returns false if H is too large for this, or if an edge has got
  /// another vertex since take().
  bool lay_out(const HessianPlaces& places, std::uint64_t stamp);
  /// The `stamp` of the last lay_out(), or 0 if the edges have changed since then.
  std::uint64_t stamp() const { return stamp_; }
  /// The numbers of values that the sums of parts need behind H and behind the gradient.
  std::uint32_t extra_values() const { return extra_values_; }
  std::uint32_t extra_scalars() const { return extra_scalars_; }
  /// Sets H and the gradient to zero, with the sums of parts.
  void clear(double* values, double* gradient) const;
  /// Adds the edges to H and to the gradient JᵀΩe, after clear(). Calls computeError() of the edges only if
  /// `with_errors` is true. Both arrays include the sums of parts.
  BatchPass linearize(double* values, double* gradient, bool with_errors);

 private:
  void make_sums(const BatchDivision& division, int vertices);
  BatchPass for_all_parts(boxplus::detail::FunctionRef<void(BatchPart&, BatchPass&)> task);
  void add_sums(double* values, double* gradient) const;

  std::vector<std::unique_ptr<EdgeTile>> tiles_;  // of the parts; they stay, because edges point to them
  std::vector<std::unique_ptr<BatchPart>> parts_;
  std::uint64_t stamp_ = 0;
  std::uint32_t extra_values_ = 0, extra_scalars_ = 0, values_ = 0, scalars_ = 0;
};

}  // namespace internal
}  // namespace g2o
