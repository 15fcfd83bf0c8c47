// SPDX-License-Identifier: BSD-3-Clause
// Two more kinds of sparse block matrices. SparseBlockMatrixCCS stores its blocks in contiguous lists, one
// list per column. SparseBlockMatrixHashMap stores its blocks in hash maps.
#pragma once
#ifndef G2O_SPARSE_BLOCK_MATRIX_CCS_H
#define G2O_SPARSE_BLOCK_MATRIX_CCS_H

#include <algorithm>
#include <unordered_map>
#include <vector>

#include "g2o/core/block_layout.h"
#include "g2o/core/eigen_types.h"
#include "g2o/core/matrix_operations.h"

namespace g2o {

/// A block matrix in compressed columns that does not own its blocks. It refers to the block boundaries of
/// another matrix, which must outlive this object.
template <class MatrixType>
class SparseBlockMatrixCCS {
 public:
  using SparseMatrixBlock = MatrixType;

  struct RowBlock {
    int row = -1;
    MatrixType* block = nullptr;
    RowBlock() = default;
    RowBlock(int r, MatrixType* b) : row(r), block(b) {}
    bool operator<(const RowBlock& other) const { return row < other.row; }
  };
  using SparseColumn = std::vector<RowBlock>;

  SparseBlockMatrixCCS(const std::vector<int>& rowIndices, const std::vector<int>& colIndices)
      : _rowBlockIndices(rowIndices), _colBlockIndices(colIndices) {}

  int cols() const { return _colBlockIndices.empty() ? 0 : _colBlockIndices.back(); }
  int rows() const { return _rowBlockIndices.empty() ? 0 : _rowBlockIndices.back(); }
  int rowsOfBlock(int r) const { return internal::blockSize(_rowBlockIndices, r); }
  int colsOfBlock(int c) const { return internal::blockSize(_colBlockIndices, c); }
  int rowBaseOfBlock(int r) const { return internal::blockBase(_rowBlockIndices, r); }
  int colBaseOfBlock(int c) const { return internal::blockBase(_colBlockIndices, c); }

  const std::vector<SparseColumn>& blockCols() const { return _blockCols; }
  std::vector<SparseColumn>& blockCols() { return _blockCols; }
  const std::vector<int>& rowBlockIndices() const { return _rowBlockIndices; }
  const std::vector<int>& colBlockIndices() const { return _colBlockIndices; }

  /// Adds thisᵀ · src to `dest`. If `dest` is null, allocates it with new[].
  void rightMultiply(double*& dest, const double* src) const {
    const int size = cols();
    if (dest == nullptr) dest = new double[static_cast<size_t>(size)]();
    Eigen::Map<VectorX> to(dest, size);
    const Eigen::Map<const VectorX> from(src, rows());
    for (size_t c = 0; c < _blockCols.size(); ++c) {
      const int base = colBaseOfBlock(static_cast<int>(c));
      for (const RowBlock& entry : _blockCols[c])
        internal::atxpy(*entry.block, from, rowBaseOfBlock(entry.row), to, base);
    }
  }

  /// Sorts the blocks of each column by row.
  void sortColumns() {
    for (SparseColumn& column : _blockCols) std::sort(column.begin(), column.end());
  }

  /// Writes the scalars as compressed columns and returns their number. If `upperTriangle` is true, skips the
  /// scalars below the diagonal.
  int fillCCS(int* Cp, int* Ci, double* Cx, bool upperTriangle = false) const {
    return internal::fillCCS(scalars(upperTriangle), cols(), Cp, Ci, Cx);
  }
  /// Writes only the values of the scalars, in the same order as the other overload.
  int fillCCS(double* Cx, bool upperTriangle = false) const {
    return internal::fillCCS(scalars(upperTriangle), Cx);
  }

 protected:
  const std::vector<int>& _rowBlockIndices;
  const std::vector<int>& _colBlockIndices;
  std::vector<SparseColumn> _blockCols;

 private:
  auto scalars(bool upperTriangle) const {
    return [this, upperTriangle](auto&& begin, auto&& take) {
      internal::visitScalars(
          _blockCols, _rowBlockIndices, _colBlockIndices, upperTriangle,
          [](const RowBlock& entry) { return entry.row; },
          [](const RowBlock& entry) -> const MatrixType& { return *entry.block; }, begin, take);
    };
  }
};

/// A block matrix that finds its blocks by hashing. Blocks can be added at any time.
template <class MatrixType>
class SparseBlockMatrixHashMap {
 public:
  using SparseMatrixBlock = MatrixType;
  using SparseColumn = std::unordered_map<int, MatrixType*>;

  /// Refers to the block boundaries of another matrix, which must outlive this matrix. Owns its blocks until
  /// SparseBlockMatrix::takePatternFromHash() takes them.
  SparseBlockMatrixHashMap(const std::vector<int>& rowIndices, const std::vector<int>& colIndices)
      : _rowBlockIndices(rowIndices), _colBlockIndices(colIndices) {}
  SparseBlockMatrixHashMap(const SparseBlockMatrixHashMap&) = delete;
  SparseBlockMatrixHashMap& operator=(const SparseBlockMatrixHashMap&) = delete;
  ~SparseBlockMatrixHashMap() {
    for (const SparseColumn& column : _blockCols) {
      for (const auto& entry : column) delete entry.second;
    }
  }

  int cols() const { return _colBlockIndices.empty() ? 0 : _colBlockIndices.back(); }
  int rows() const { return _rowBlockIndices.empty() ? 0 : _rowBlockIndices.back(); }
  int rowsOfBlock(int r) const { return internal::blockSize(_rowBlockIndices, r); }
  int colsOfBlock(int c) const { return internal::blockSize(_colBlockIndices, c); }
  int rowBaseOfBlock(int r) const { return internal::blockBase(_rowBlockIndices, r); }
  int colBaseOfBlock(int c) const { return internal::blockBase(_colBlockIndices, c); }

  const std::vector<SparseColumn>& blockCols() const { return _blockCols; }
  std::vector<SparseColumn>& blockCols() { return _blockCols; }
  const std::vector<int>& rowBlockIndices() const { return _rowBlockIndices; }
  const std::vector<int>& colBlockIndices() const { return _colBlockIndices; }

  /// Returns the block at (r, c). If there is none, creates the block. A new block is zero if `zeroBlock` is
  /// true. Otherwise, it is uninitialized.
  MatrixType* addBlock(int r, int c, bool zeroBlock = false) {
    if (_blockCols.size() <= static_cast<size_t>(c)) _blockCols.resize(_colBlockIndices.size());
    MatrixType*& block = _blockCols[static_cast<size_t>(c)][r];
    if (block == nullptr) {
      block = new MatrixType(rowsOfBlock(r), colsOfBlock(c));
      if (zeroBlock) block->setZero();
    }
    return block;
  }

 protected:
  const std::vector<int>& _rowBlockIndices;
  const std::vector<int>& _colBlockIndices;
  std::vector<SparseColumn> _blockCols;
};

}  // namespace g2o

#endif  // G2O_SPARSE_BLOCK_MATRIX_CCS_H
