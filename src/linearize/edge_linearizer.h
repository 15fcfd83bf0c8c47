// SPDX-License-Identifier: BSD-3-Clause
// Linearizes lists of edges of one pool at the current estimates, tile by tile.
#pragma once

#include <cstdint>

#include "boxplus/base/function_ref.h"
#include "plan/plan.h"

namespace boxplus {

class PacedStop;
struct PlacedTile;
struct TileMemory;

struct LinearizeOptions {
  bool numeric_jacobians = false;  ///< differentiate every edge numerically
  /// Adds the second-order term of Triggs et al. ("Bundle adjustment: a modern synthesis", 2000, §4.3) for
  /// robust edges: H += Jᵀ (ρ′Ω + 2ρ″ Ωe eᵀΩ) J. The curvature along e is at least 1e-4 of that of ρ′Ω. There
  /// is no such term if ρ is concave along e, or if ρ″ is not finite.
  bool triggs_correction = false;
};

class EdgeLinearizer {
 public:
  explicit EdgeLinearizer(const Graph& graph) : graph_(&graph) {}

  /// Where the values of H and of the gradient begin, as the targets of a Scatter count them.
  struct Sums {
    double *values, *gradient;
  };
  /// Adds ρ′ JᵀΩJ and ρ′ JᵀΩe of the enabled edges [begin, end) of `scatter` at their targets. Returns false
  /// if the token was raised.
  bool add(const Scatter& scatter, std::uint32_t begin, std::uint32_t end, TileMemory& memory,
           const LinearizeOptions& options, PacedStop& pace, const Sums& sums) const;
  /// Calls f for each tile of the edges [begin, end). `in_lanes` says whether f can read lanes. Returns false
  /// if the token was raised.
  bool for_each_tile(const Scatter& scatter, std::uint32_t begin, std::uint32_t end, TileMemory& memory,
                     const LinearizeOptions& options, bool in_lanes, PacedStop& pace,
                     detail::FunctionRef<void(const PlacedTile&)> f) const;

 private:
  const Graph* graph_;
};

/// Whether tiles of these edges are large enough for SIMD lanes. `edge` is any edge of the pool.
bool fits_kernels(const detail::EdgePool& pool, std::uint32_t edge);

}  // namespace boxplus
