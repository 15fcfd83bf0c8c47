// SPDX-License-Identifier: BSD-3-Clause
// Eigenspaces of small symmetric matrices.
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

/// An orthonormal basis of the right singular vectors x of A with ‖A x‖ ≤ least · ‖x‖.
inline Eigen::MatrixXd kernel_of(const Eigen::MatrixXd& A, double least) {
  return eigenvectors_of(A.transpose() * A, [&](double squared) { return squared <= least * least; });
}

}  // namespace boxplus
