// SPDX-License-Identifier: BSD-3-Clause
// The elimination of vertices while H is being computed.
#pragma once

#include <cstdint>
#include <span>

#include "boxplus/linear/linear_solver.h"

namespace boxplus {

/// LinearSolver::factorize() and solve() in steps. First, call begin(). Then, call eliminate_columns() for
/// all columns of each slice, in order, as soon as these columns of H and their part of the damping and of
/// the right-hand side are complete. Then, call finish(). The eliminated columns of H need not be stored.
class ColumnElimination {
 public:
  virtual ~ColumnElimination() = default;

  /// The number of slices of eliminated columns, or 0 if this solver cannot eliminate while H is being
  /// computed. Every slice begins and ends at AnalyzeHints::elimination_bounds: slice s of n begins at bound
  /// ⌊b s / n⌋ of b + 1 bounds.
  virtual int slices() const = 0;
  /// control.right_hand_side must not be null.
  virtual void begin(const Damping& damping, const SolveControl& control) = 0;
  /// Eliminates the columns [first, last), whose values begin at `values`. Different threads may do this for
  /// different slices.
  virtual void eliminate_columns(int slice, std::uint32_t first, std::uint32_t last, const double* values,
                                 const StopToken& stop) = 0;
  /// `values` are the stored values of H.
  virtual FactorResult finish(std::span<const double> values, const Damping& damping,
                              const SolveControl& control) = 0;
  /// Computes the part of x that belongs to kept blocks, for the right-hand side of begin().
  virtual SolveResult solve_kept(double* x, const SolveControl& control) = 0;
  /// x ← (V + λD)⁻¹ x for one eliminated block.
  virtual void solve_eliminated(std::uint32_t block, double* x) const = 0;

 protected:
  ColumnElimination() = default;
  ColumnElimination(const ColumnElimination&) = default;
  ColumnElimination& operator=(const ColumnElimination&) = default;
};

}  // namespace boxplus
