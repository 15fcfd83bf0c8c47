// SPDX-License-Identifier: BSD-3-Clause
// Subspaces that small matrices define.
#pragma once

#include "base/symmetric_eigen.h"

namespace boxplus {

/// Orthonormal eigenvectors of the symmetric matrix A, as columns, for the eigenvalues that `wanted` accepts.
template <class F>
Eigen::MatrixXd eigenvectors_of(const Eigen::MatrixXd& A, F&& wanted) {
  const SymmetricEigen eigen = symmetric_eigen(A);
  Eigen::MatrixXd result(A.rows(), A.cols());
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i < A.rows(); ++i) {
    if (wanted(eigen.values[i])) result.col(count++) = eigen.vectors.col(i);
  }
  return result.leftCols(count);
}

/// An orthonormal basis of the right singular vectors x of A with ‖A x‖ ≤ least · ‖x‖, by one-sided Jacobi
/// rotations (Hestenes 1958). Unlike eigenvalues of AᵀA, small singular values have small errors.
Eigen::MatrixXd kernel_of(Eigen::MatrixXd A, double least);

}  // namespace boxplus
