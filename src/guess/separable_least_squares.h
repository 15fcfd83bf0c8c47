// SPDX-License-Identifier: BSD-3-Clause
// Sparse linear least squares with several right-hand sides.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boxplus/linear/make_linear_solver.h"
#include "guess/frame_math.h"
#include "guess/initial_guess.h"

namespace boxplus::guess {

/// Minimizes Σ ‖ A_i X_i − B_j X_j − C ‖²_W over blocks X_i of dim(i) × columns values.
///
/// Call join() for every pair of blocks that share a term, then finish_structure(), then add() for every
/// term, and then solve().
class SeparableLeastSquares {
 public:
  static constexpr std::uint32_t kConstant = 0xFFFFFFFFu;  ///< the index of blocks that are not unknowns

  SeparableLeastSquares(std::vector<std::uint32_t> dims, int columns)
      : dims_(std::move(dims)), columns_(columns) {}

  void join(std::uint32_t i, std::uint32_t j);
  /// Throws Stopped when the token is raised.
  void finish_structure(const StopToken& stop = {});
  /// Adds one term. If i (or j) is kConstant, `a` (or `b`) is not used. `weight` is the diagonal of W.
  void add(std::uint32_t i, const SmallMatrix& a, std::uint32_t j, const SmallMatrix& b, const SmallMatrix& c,
           const SmallVector& weight);
  /// `order` is the elimination order of the blocks X_i. If it is empty, the solver computes one. If the
  /// matrix was not positive definite, solve() may be called again after more calls of add(). Throws Stopped
  /// when the token of `limits` is raised.
  LinearStatus solve(const GuessLimits& limits = {}, std::span<const std::uint32_t> order = {});
  double largest_diagonal() const;
  /// X_i, after solve().
  SmallMatrix block(std::uint32_t i) const;

 private:
  using Strided = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
  void add_square(std::uint32_t i, const SmallMatrix& a, const SmallMatrix& c, const SmallVector& weight);
  Strided rows_of(std::uint32_t i);

  std::vector<std::uint32_t> dims_;
  int columns_;
  std::vector<BlockCoordinate> pairs_;
  BlockStructure structure_;
  std::vector<double> values_;
  std::vector<double> x_;  // the right-hand sides, and then the solutions, one column after the other
};

}  // namespace boxplus::guess
