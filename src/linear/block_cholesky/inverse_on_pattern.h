// SPDX-License-Identifier: BSD-3-Clause
// The entries of A⁻¹ on the pattern of L.
#pragma once

#include <cstdint>
#include <vector>

#include "linear/block_cholesky/symbolic_factor.h"

namespace boxplus {

/// Z = (L Lᵀ)⁻¹ where L has entries, by the recursion of Takahashi, Fagan and Chin (1973) from the last
/// supernode to the first: with S = L21 L11⁻¹ and Z22 the part of Z on the rows below (known from the
/// ancestors),
///   Z21 = −Z22 S,   Z11 = L11⁻ᵀ L11⁻¹ − Sᵀ Z21.
/// Costs about three factorizations and the memory of one L.
class InverseOnPattern {
 public:
  void compute(const SymbolicFactor& symbolic, const double* panels);
  void clear() { computed_ = false; }
  bool computed() const { return computed_; }

  /// Writes block (row, column) of Z (positions in the elimination order; column-major). False where it is
  /// not in the pattern.
  bool read(const SymbolicFactor& symbolic, std::uint32_t row, std::uint32_t column, double* out) const;

 private:
  void compute_front(const SymbolicFactor& symbolic, const Front& front, const double* panel);
  void gather_below(const SymbolicFactor& symbolic, const Front& front);

  std::vector<double> panels_;  // laid out as those of L; the top square holds both triangles
  std::vector<double> below_, ratio_, ratio_transposed_;
  bool computed_ = false;
};

}  // namespace boxplus
