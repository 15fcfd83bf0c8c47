// SPDX-License-Identifier: BSD-3-Clause
// Any blocks of an inverse, from those of its lower triangle.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "boxplus/linear/linear_solver.h"

namespace boxplus {

class InverseBlocks {
 public:
  /// `pairs`: the blocks (row, column), in either triangle. `structure` must outlive this.
  InverseBlocks(const BlockStructure& structure, std::span<const BlockCoordinate> pairs);
  /// Asks a solver that has factorized. False if it cannot do it, or a value is not finite.
  bool compute(LinearSolver& solver, const StopToken& stop = {});
  /// Of the k-th pair.
  Eigen::MatrixXd block(std::size_t k) const;

 private:
  const BlockStructure* structure_;
  std::vector<BlockCoordinate> lower_;
  std::vector<bool> transposed_;
  std::vector<std::size_t> start_;
  std::vector<double> values_;
};

}  // namespace boxplus
