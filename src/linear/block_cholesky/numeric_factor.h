// SPDX-License-Identifier: BSD-3-Clause
// The numerical multifrontal factorisation (Duff and Reid 1983; Liu 1992).
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "boxplus/linear/linear_solver.h"
#include "linear/block_cholesky/symbolic_factor.h"
#include "linear/lost_pivot.h"

namespace boxplus {

/// The pivots that lost most digits, smallest ratio first.
class Suspects {
 public:
  struct Suspect {
    std::uint32_t scalar;  // permuted
    double ratio;
  };
  void clear() { count_ = 0; }
  void add(Suspect suspect);
  std::span<Suspect> list() { return std::span(list_).first(count_); }

 private:
  std::array<Suspect, 4> list_{};
  std::size_t count_ = 0;
};

struct NumericFactor {
  double* arena;          // panels, then update matrices
  double* minimum_pivot;  // kLostPivot · diagonal of A + λD, by permuted scalar
  Suspects suspects;
};

/// Factorises A + λD into the panels. Returns the permuted scalar of the first lost pivot, or the number of
/// scalars. Reads only the lower triangle of `values`.
std::uint32_t factorize_fronts(const SymbolicFactor& symbolic, const BlockStructure& structure,
                               const double* values, const Damping& damping, NumericFactor& factor);

}  // namespace boxplus
