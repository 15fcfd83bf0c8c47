// SPDX-License-Identifier: BSD-3-Clause
// Adds JᵀΩJ and JᵀΩe of one edge of a tile to H and to the gradient.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "boxplus/graph/information.h"
#include "boxplus/linearize/plan.h"

namespace boxplus {

/// The weights of one edge: its Ω is scaled by `first` = max(0, ρ′) and gets the rank-one term `second` · Ωe
/// eᵀΩ.
struct EdgeWeight {
  double first = 1;
  double second = 0;
};

/// The weights of an edge with squared error e2. `triggs` asks for the second-order term.
EdgeWeight edge_weight(const RobustKernel* kernel, double e2, bool triggs);

/// One edge of a tile.
struct EdgeSystem {
  int rows, cols;
  std::span<const int> dims;  ///< tangent size of each vertex
  const double* error;
  const double* jacobian;  ///< rows × cols, column-major
};

/// The number of scratch values with which accumulate() uses the dense kernels for a large edge; 0 if these
/// are not faster for this edge.
std::size_t dense_scratch(int rows, int cols);

/// Adds the edge to H (`values`) and to the gradient, at the places `targets`. `weighted`, `weighted_error`
/// and `dense` are scratch of rows·cols, rows + cols and dense_scratch() values. If `dense` is null, large
/// edges are added with scalar loops.
void accumulate(const EdgeSystem& edge, const detail::InformationView& information, const EdgeWeight& weight,
                const std::uint32_t* targets, double* values, double* gradient, double* weighted,
                double* weighted_error, double* dense = nullptr);

}  // namespace boxplus
