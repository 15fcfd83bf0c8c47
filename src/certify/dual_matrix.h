// SPDX-License-Identifier: BSD-3-Clause
// The matrix S of the dual problem, and the lower bound that it gives.
//
// Let G = Q X. The multipliers are Λ_i = sym(G_i X_iᵀ) of the d rotation rows, and S = Q − diag(Λ_i, 0). For
// other poses Y = X + D,
//   F(Y) − F(X) = 2 tr(Dᵀ S X) + tr(Dᵀ S D),
// because the Λ_i add the same constant to both sides: Y_i Y_iᵀ = X_i X_iᵀ = I. Y may be moved as a whole so
// that its pinned pose is that of X, and D is zero there. Let S₀ be S without the rows and columns of pinned
// poses, and r those of S X. If S₀ is positive definite, the minimum over all D is
//   F(Y) − F(X) ≥ −tr(rᵀ S₀⁻¹ r).
// This is a lower bound for F. It holds for any X, and it is F(X) itself if X is stationary (r = 0). If only
// S₀ + μ I is positive definite, where I is for the rows of rotations, the bound is lower by 4 d μ for each
// pose, because ‖D_i‖² ≤ 4 d there.
//
// Rounding. The sums in S and its Cholesky factor are exact for a matrix that differs from S by at most ρ σ_i
// in each diagonal entry, in the order of semi-definite matrices. σ_i is the sum of the magnitudes in
// diagonal entry i, and ρ = 8 ε √n for n rows (Higham & Mary, "A new approach to probabilistic rounding error
// analysis", 2019). So S₀ − ρ diag(σ) is factorized: if this succeeds, S₀ is positive definite, and the
// smaller matrix gives a larger gap. If X_i X_iᵀ is I only up to E_i, F(Y) − F(X) has another term −Σ tr(Λ_i
// E_i), and a bound of it is part of the gap.
#pragma once

#include <optional>
#include <vector>

#include "certify/chordal_problem.h"
#include "certify/sparse_factor.h"

namespace boxplus::certificate {

class DualMatrix {
 public:
  DualMatrix(const ChordalProblem& problem, const Resources& resources);

  /// Computes S and S X at these poses.
  void update(const StackedPoses& poses);
  const BlockStructure& structure() const { return structure_; }
  /// The block with index k of structure().
  Block block(std::uint32_t column, std::uint32_t k) const;
  /// The rows of S X that belong to a pose.
  const StackedPose& residual(std::uint32_t pose) const { return residual_[pose]; }

  /// A number by which no poses have a lower F than the exact F of these poses. Empty if S₀ + μ I is not
  /// positive definite for the μ that lowers the bound by `slack`, or if rounding may be the reason that it
  /// is.
  std::optional<double> gap(double slack);
  /// v with vᵀ S₀ v < 0, d + 1 values per block, whose longest rotation part has length one. Empty if none is
  /// found.
  std::optional<std::vector<double>> negative_direction();

 private:
  void add_edges();
  double* entry(std::uint32_t row, std::uint32_t column);
  double largest_diagonal() const;
  std::vector<double> residual_columns() const;

  const ChordalProblem& problem_;
  BlockStructure structure_;
  std::vector<double> quadratic_, values_;  // of Q, and of S
  std::vector<double> rotation_rows_;       // 1 for the rows of rotations, 0 for translations
  std::vector<double> magnitudes_;          // σ
  double multipliers_ = 0;                  // the sum of the magnitudes in all Λ_i
  StackedPoses residual_;
  std::optional<SparseFactor> factor_;
};

}  // namespace boxplus::certificate
