// SPDX-License-Identifier: BSD-3-Clause
// The entries of A⁻¹ on the pattern of L.
#pragma once

#include <cstdint>
#include <vector>

#include "linear/block_cholesky/symbolic_factor.h"

namespace boxplus {

/// The entries of Z = (L Lᵀ)⁻¹ at the nonzeros of L. The recursion of Takahashi, Fagan and Chin (1973)
/// computes them from the last supernode to the first. Let S = L21 L11⁻¹, and let Z22 be the part of Z for
/// the rows below the supernode, which is already known from its ancestors. Then
///   Z21 = −Z22 S,   Z11 = L11⁻ᵀ L11⁻¹ − Sᵀ Z21.
/// Takes about as long as three factorizations, and as much memory as L.
class InverseOnPattern {
 public:
  void compute(const SymbolicFactor& symbolic, const double* panels);
  void clear() { computed_ = false; }
  bool computed() const { return computed_; }

  /// Writes block (row, column) of Z to `out`, column-major. `row` and `column` are positions in the
  /// elimination order. Returns false if the block is not in the pattern.
  bool read(const SymbolicFactor& symbolic, std::uint32_t row, std::uint32_t column, double* out) const;

 private:
  void compute_front(const SymbolicFactor& symbolic, const Front& front, const double* panel);
  void gather_below(const SymbolicFactor& symbolic, const Front& front);

  std::vector<double> panels_;  // in the layout of L, but the top square of each panel has both triangles
  std::vector<double> below_, ratio_, ratio_transposed_;
  bool computed_ = false;
};

}  // namespace boxplus
