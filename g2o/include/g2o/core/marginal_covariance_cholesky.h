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

/// Entries of the inverse of A = Pᵀ L Lᵀ P, given the Cholesky factor L.
///
/// All entries on the pattern of L come from one backward sweep (Takahashi, Fagan, Chin, 1973); others cost
/// two triangular solves per column.
class G2O_CORE_API MarginalCovarianceCholesky {
 public:
  MarginalCovarianceCholesky();
  ~MarginalCovarianceCholesky();

  /// L in compressed columns: n of them, each with its diagonal entry first, and with every entry that the
  /// elimination fills. permInv[i]: where scalar i of A stands in L; null: where it stands in A. All four
  /// must stay until the last computation.
  void setCholeskyFactor(int n, int* Lp, int* Li, double* Lx, int* permInv);

  /// The diagonal blocks, column by column: block i, which ends at scalar blockIndices[i], at covBlocks[i].
  void computeCovariance(double** covBlocks, const std::vector<int>& blockIndices);
  /// The blocks (i, j) of A⁻¹, whose blocks end at the scalars rowBlockIndices.
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

  std::vector<double> inverse_;               ///< on the pattern of L; empty until it is asked for
  std::unordered_map<int, VectorX> columns_;  ///< of the inverse, beside the pattern
};

}  // namespace g2o

#endif  // G2O_MARGINAL_COVARIANCE_CHOLESKY_H
