// SPDX-License-Identifier: BSD-3-Clause
// Provides blocks in both triangles of an inverse, although solvers compute only blocks in the lower
// triangle.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "boxplus/linear/linear_solver.h"

namespace boxplus {

class InverseBlocks {
 public:
  /// `pairs` lists the blocks (row, column), in either triangle. `structure` must outlive this object.
  InverseBlocks(const BlockStructure& structure, std::span<const BlockCoordinate> pairs);
  /// Computes the blocks with a solver whose factorize() has succeeded. Returns false if the solver cannot do
  /// this, or if a value is not finite.
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
