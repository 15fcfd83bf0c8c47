// SPDX-License-Identifier: BSD-3-Clause
// The eigendecomposition of symmetric matrices. It is not a template, so that Eigen's code is compiled only
// once.
#pragma once

#include <Eigen/Core>

namespace boxplus {

/// The decomposition A = V diag(λ) Vᵀ.
struct SymmetricEigen {
  Eigen::VectorXd values;   ///< the eigenvalues λ, ascending
  Eigen::MatrixXd vectors;  ///< V, which is orthonormal; column i belongs to values[i]
};

/// Decomposes A. Reads only the lower triangle of A. Takes O(n³).
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A);

}  // namespace boxplus
