// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "g2o/core/optimizable_graph.h"

namespace g2o {
namespace internal {

/// What one pass over the edges in batches found.
struct BatchPass {
  double chi2 = 0;  ///< the sum of ρ(eᵀΩe) over the edges that are in no list below
  bool any_incomplete = false;
  /// Complete edges whose kernels are not known to be thread-safe.
  OptimizableGraph::EdgeContainer with_unknown_kernels;
  /// Edges that a linearization did not add to H, including those above.
  OptimizableGraph::EdgeContainer not_added;

  void append(const BatchPass& next) {
    chi2 += next.chi2;
    any_incomplete = any_incomplete || next.any_incomplete;
    with_unknown_kernels.insert(with_unknown_kernels.end(), next.with_unknown_kernels.begin(),
                                next.with_unknown_kernels.end());
    not_added.insert(not_added.end(), next.not_added.begin(), next.not_added.end());
  }
};

}  // namespace internal
}  // namespace g2o
