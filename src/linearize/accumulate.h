// SPDX-License-Identifier: BSD-3-Clause
// Adds JᵀΩJ and JᵀΩe of one edge of a tile to H and to the gradient.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "boxplus/graph/information.h"
#include "plan/dense_scratch.h"
#include "plan/plan.h"

namespace boxplus {

/// The weights of one edge. The weights replace the edge's Ω by first · Ω + second · Ωe eᵀΩ. `first` is
/// max(0, ρ′). `second` is Triggs' correction: 2ρ″, within its bounds (LinearizeOptions), and 0 if ρ″ is not
/// finite.
struct EdgeWeight {
  double first = 1;
  double second = 0;
};

/// Computes the weights of an edge with the squared error e2. `second` is 0 unless `triggs` is true.
EdgeWeight edge_weight(const RobustKernel* kernel, double e2, bool triggs);

/// One edge of a tile.
struct EdgeSystem {
  int rows, cols;
  std::span<const int> dims;  ///< the tangent size of each vertex
  const double* error;
  const double* jacobian;  ///< rows × cols, column-major
};

/// Adds the edge to H (`values`) and to the gradient, at the places that `targets` lists. `weight` is ρ′.
/// `weighted`, `weighted_error` and `dense` are scratch memory for rows · cols, rows + cols and
/// dense_scratch() values. If `dense` is null, adds large edges with scalar loops.
void accumulate(const EdgeSystem& edge, const detail::InformationView& information, double weight,
                const std::uint32_t* targets, double* values, double* gradient, double* weighted,
                double* weighted_error, double* dense = nullptr);

}  // namespace boxplus
