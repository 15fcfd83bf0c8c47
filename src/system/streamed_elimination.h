// SPDX-License-Identifier: BSD-3-Clause
// Eliminates vertices while their edges are being linearized.
#pragma once

#include <span>
#include <vector>

#include "boxplus/system/timings.h"
#include "linear/schur/column_elimination.h"
#include "linearize/linearizer.h"

namespace boxplus {

/// A batch of vertices is eliminated as soon as its edges have been linearized, while its columns of H are in
/// the cache. So these columns need not be stored.
class StreamedElimination {
 public:
  /// All arguments must outlive this object.
  StreamedElimination(const Plan& plan, Linearizer& linearizer, ColumnElimination& solver)
      : plan_(&plan), linearizer_(&linearizer), solver_(&solver) {}

  /// Allocates. To be called when `solver` has been analyzed.
  void prepare() { seconds_.resize(static_cast<std::size_t>(slices())); }
  bool is_possible() const { return solver_->slices() > 0; }
  int slices() const { return solver_->slices(); }
  /// Linearizes all edges, and eliminates each batch. Calls `before` before the elimination of a batch.
  /// control.right_hand_side must not be null.
  void run(const Damping& damping, const SolveControl& control, const LinearizeOptions& options,
           detail::Timings& timings, Linearizer::AfterBatch before);
  /// Completes H with its stored values, and factorizes it.
  FactorResult finish(const Damping& damping, const SolveControl& control) {
    return solver_->finish(linearizer_->values(), damping, control);
  }
  /// Computes the step for the right-hand side of run(). Linearizes edges again instead of reading columns of
  /// eliminated vertices.
  SolveResult solve(const SolveControl& control, const LinearizeOptions& options, std::span<double> step);

 private:
  const Plan* plan_;
  Linearizer* linearizer_;
  ColumnElimination* solver_;
  std::vector<double> seconds_;  // of elimination, per slice
};

}  // namespace boxplus
