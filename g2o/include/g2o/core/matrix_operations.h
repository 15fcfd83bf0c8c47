// SPDX-License-Identifier: BSD-3-Clause
// Products of a block with parts of a vector.
#pragma once
#ifndef G2O_CORE_MATRIX_OPERATIONS_H
#define G2O_CORE_MATRIX_OPERATIONS_H

#include "g2o/core/eigen_types.h"

namespace g2o {
namespace internal {

/// Adds A times the part of x that begins at xoff to the part of y that begins at yoff.
template <typename MatrixType>
inline void axpy(const MatrixType& A, const Eigen::Map<const VectorX>& x, int xoff, Eigen::Map<VectorX>& y,
                 int yoff) {
  y.segment(yoff, A.rows()).noalias() += A * x.segment(xoff, A.cols());
}

/// Adds Aᵀ times the part of x that begins at xoff to the part of y that begins at yoff.
template <typename MatrixType>
inline void atxpy(const MatrixType& A, const Eigen::Map<const VectorX>& x, int xoff, Eigen::Map<VectorX>& y,
                  int yoff) {
  y.segment(yoff, A.cols()).noalias() += A.transpose() * x.segment(xoff, A.rows());
}

}  // namespace internal
}  // namespace g2o

#endif  // G2O_CORE_MATRIX_OPERATIONS_H
