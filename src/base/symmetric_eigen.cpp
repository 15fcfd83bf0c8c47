// SPDX-License-Identifier: BSD-3-Clause
#include "base/symmetric_eigen.h"

#include <Eigen/Eigenvalues>

namespace boxplus {

SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A) {
  if (A.rows() == 0) return {};
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(A);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace boxplus
