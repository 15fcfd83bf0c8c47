// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SPARSE_BLOCK_MATRIX_DIAGONAL_H
#define G2O_SPARSE_BLOCK_MATRIX_DIAGONAL_H

#include <vector>

#include "g2o/core/block_layout.h"
#include "g2o/core/eigen_types.h"
#include "g2o/core/matrix_operations.h"

namespace g2o {

/// A block-diagonal matrix. Refers to the block boundaries of another matrix, which must outlive this matrix.
template <class MatrixType>
class SparseBlockMatrixDiagonal {
 public:
  using SparseMatrixBlock = MatrixType;
  using DiagonalVector = std::vector<MatrixType, Eigen::aligned_allocator<MatrixType>>;

  explicit SparseBlockMatrixDiagonal(const std::vector<int>& blockIndices) : _blockIndices(blockIndices) {}

  int cols() const { return _blockIndices.empty() ? 0 : _blockIndices.back(); }
  int rows() const { return cols(); }
  int dimOfBlock(int r) const { return internal::blockSize(_blockIndices, r); }
  int baseOfBlock(int r) const { return internal::blockBase(_blockIndices, r); }

  const DiagonalVector& diagonal() const { return _diagonal; }
  DiagonalVector& diagonal() { return _diagonal; }
  const std::vector<int>& blockIndices() const { return _blockIndices; }

  /// Adds this · src to `dest`. If `dest` is null, allocates it with new[].
  void multiply(double*& dest, const double* src) const {
    const int size = cols();
    if (dest == nullptr) dest = new double[static_cast<size_t>(size)]();
    Eigen::Map<VectorX> to(dest, size);
    const Eigen::Map<const VectorX> from(src, size);
    for (size_t i = 0; i < _diagonal.size(); ++i) {
      const int base = baseOfBlock(static_cast<int>(i));
      internal::axpy(_diagonal[i], from, base, to, base);
    }
  }

 protected:
  const std::vector<int>& _blockIndices;
  DiagonalVector _diagonal;
};

}  // namespace g2o

#endif  // G2O_SPARSE_BLOCK_MATRIX_DIAGONAL_H
