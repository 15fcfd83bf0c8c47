// SPDX-License-Identifier: BSD-3-Clause
// The numerical multifrontal factorisation (Duff and Reid 1983; Liu 1992).
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "boxplus/linear/linear_solver.h"
#include "linear/block_cholesky/symbolic_factor.h"

namespace boxplus {

/// A pivot d of the scalar column j counts as lost when d ≤ kLostPivot · vᵀ diag(A + λD) v. Here v, with v_j
/// = 1, is the direction along which eliminating the columns before j leaves just d: vᵀ(A + λD) v = d.
/// Rounding perturbs (A + λD)_ik by about ε √(a_ii a_kk), hence d by about ε vᵀ diag(A + λD) v, so that below
/// 45 ε = 1e-14 of this there are no digits left. As d / (vᵀ diag v) ≥ 1 / (condition number of A + λD scaled
/// to unit diagonal), no matrix whose scaled condition number is below 1e14 is ever refused; the freedom of a
/// pose graph without anchor, which leaves noise of a few ε vᵀ diag v on the last pivots, is found.
///
/// v_j = 1 makes d ≤ kLostPivot · a_jj sufficient, which costs one comparison. The sum needs a
/// back-substitution and is formed for the few smallest pivots below kSuspiciousPivot · a_jj only (see
/// check_suspects).
inline constexpr double kLostPivot = 1e-14;
inline constexpr double kSuspiciousPivot = 1e-6;

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
