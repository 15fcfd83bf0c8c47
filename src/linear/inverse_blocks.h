// SPDX-License-Identifier: BSD-3-Clause
// Blocks of an inverse in both triangles, from those of its lower triangle.
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
  /// Lets a solver that has factorized compute the blocks. Returns false if it cannot, or if a value is not
  /// finite.
  bool compute(LinearSolver& solver, const StopToken& stop = {});
  /// The block of the k-th pair.
  Eigen::MatrixXd block(std::size_t k) const;

 private:
  const BlockStructure* structure_;
  std::vector<BlockCoordinate> lower_;
  std::vector<bool> transposed_;
  std::vector<std::size_t> start_;
  std::vector<double> values_;
};

}  // namespace boxplus
