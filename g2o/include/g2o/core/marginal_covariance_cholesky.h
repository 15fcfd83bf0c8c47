// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_MARGINAL_COVARIANCE_CHOLESKY_H
#define G2O_MARGINAL_COVARIANCE_CHOLESKY_H

#include <unordered_map>
#include <utility>
#include <vector>

#include "g2o/core/g2o_core_api.h"
#include "g2o/core/sparse_block_matrix.h"

namespace g2o {

/// Computes entries of the inverse of A = Pᵀ L Lᵀ P from the Cholesky factor L.
///
/// One backward sweep (Takahashi, Fagan, Chin, 1973) computes all entries of the inverse in the sparsity
/// pattern of L. For entries outside the pattern, each column of the inverse costs two triangular solves.
class G2O_CORE_API MarginalCovarianceCholesky {
 public:
  MarginalCovarianceCholesky();
  ~MarginalCovarianceCholesky();

  /// L has n compressed columns. Each column begins with its diagonal entry and must include all fill-in.
  /// permInv[i] is the row of L for scalar i of A. If permInv is null, L has the same order as A. All four
  /// arrays must stay valid until the last computation.
  void setCholeskyFactor(int n, int* Lp, int* Li, double* Lx, int* permInv);

  /// Computes the diagonal blocks, stored by columns. Block i ends at scalar blockIndices[i] and is written
  /// to covBlocks[i].
  void computeCovariance(double** covBlocks, const std::vector<int>& blockIndices);
  /// Computes the blocks (i, j) of A⁻¹. Block i ends at scalar rowBlockIndices[i].
  void computeCovariance(SparseBlockMatrix<MatrixX>& spinv, const std::vector<int>& rowBlockIndices,
                         const std::vector<std::pair<int, int>>& blockIndices);

 protected:
  int _n = 0;
  int* _Ap = nullptr;
  int* _Ai = nullptr;
  double* _Ax = nullptr;
  int* _perm = nullptr;

 private:
  void sweep();
  double entry(int row, int column);
  const VectorX& column(int c);

  std::vector<double> inverse_;               ///< entries on the pattern of L; empty until the first use
  std::unordered_map<int, VectorX> columns_;  ///< columns of the inverse, for entries outside the pattern
};

}  // namespace g2o

#endif  // G2O_MARGINAL_COVARIANCE_CHOLESKY_H
