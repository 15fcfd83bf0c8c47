// SPDX-License-Identifier: BSD-3-Clause
// A sparse matrix of dense blocks.
#pragma once
#ifndef G2O_SPARSE_BLOCK_MATRIX_
#define G2O_SPARSE_BLOCK_MATRIX_

#if __cplusplus < 201703L
#pragma GCC system_header  // Otherwise, compilers warn about C++17 in this header.
#endif

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <map>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "g2o/core/block_layout.h"
#include "g2o/core/eigen_types.h"
#include "g2o/core/matrix_structure.h"
#include "g2o/core/sparse_block_matrix_ccs.h"
#include "g2o/core/sparse_block_matrix_diagonal.h"
#include "g2o/stuff/sparse_helper.h"  // clients use writeVector() without including its header

namespace g2o {

/// A sparse matrix of dense blocks. Each block column is a map from block rows to blocks. Block row r spans
/// the scalar rows from rowBaseOfBlock(r) to rowBaseOfBlock(r) + rowsOfBlock(r) − 1. Block columns span
/// scalar columns in the same way.
template <class MatrixType = MatrixX>
class SparseBlockMatrix {
 public:
  using SparseMatrixBlock = MatrixType;
  using IntBlockMap = std::map<int, SparseMatrixBlock*>;

  /// rbi[r] is one past the last scalar of block row r, and cbi[c] is one past the last scalar of block
  /// column c. If `hasStorage` is true, the matrix owns its blocks.
  SparseBlockMatrix(const int* rbi, const int* cbi, int rb, int cb, bool hasStorage = true)
      : _rowBlockIndices(rbi, rbi + rb),
        _colBlockIndices(cbi, cbi + cb),
        _blockCols(static_cast<size_t>(cb)),
        _hasStorage(hasStorage) {}
  SparseBlockMatrix() : _hasStorage(true) {}
  SparseBlockMatrix(const SparseBlockMatrix&) = delete;
  SparseBlockMatrix& operator=(const SparseBlockMatrix&) = delete;
  SparseBlockMatrix(SparseBlockMatrix&& other) noexcept : _hasStorage(true) { swap(other); }
  SparseBlockMatrix& operator=(SparseBlockMatrix&& other) noexcept {
    swap(other);
    return *this;
  }
  ~SparseBlockMatrix() {
    if (_hasStorage) clear(true);
  }

  int cols() const { return _colBlockIndices.empty() ? 0 : _colBlockIndices.back(); }
  int rows() const { return _rowBlockIndices.empty() ? 0 : _rowBlockIndices.back(); }

  /// Sets all blocks to zero, or deletes them if `dealloc` is true.
  void clear(bool dealloc = false) {
    for (IntBlockMap& column : _blockCols) {
      for (auto& entry : column) {
        if (!dealloc) {
          entry.second->setZero();
        } else if (_hasStorage) {
          delete entry.second;
        }
      }
      if (dealloc) column.clear();
    }
  }

  /// Returns the block at (r, c), or nullptr if there is none. If `alloc` is true, creates a missing block
  /// and sets it to zero.
  SparseMatrixBlock* block(int r, int c, bool alloc = false) {
    IntBlockMap& column = _blockCols[static_cast<size_t>(c)];
    const auto found = column.find(r);
    if (found != column.end()) return found->second;
    if (!alloc) return nullptr;
    auto* made = new SparseMatrixBlock(rowsOfBlock(r), colsOfBlock(c));
    made->setZero();
    column.emplace(r, made);
    return made;
  }
  const SparseMatrixBlock* block(int r, int c) const {
    const IntBlockMap& column = _blockCols[static_cast<size_t>(c)];
    const auto found = column.find(r);
    return found == column.end() ? nullptr : found->second;
  }

  int rowsOfBlock(int r) const { return internal::blockSize(_rowBlockIndices, r); }
  int colsOfBlock(int c) const { return internal::blockSize(_colBlockIndices, c); }
  int rowBaseOfBlock(int r) const { return internal::blockBase(_rowBlockIndices, r); }
  int colBaseOfBlock(int c) const { return internal::blockBase(_colBlockIndices, c); }

  /// The number of scalars in all blocks.
  size_t nonZeros() const {
    size_t count = 0;
    for_each([&](int, int, const SparseMatrixBlock& b) { count += static_cast<size_t>(b.size()); });
    return count;
  }
  size_t nonZeroBlocks() const {
    size_t count = 0;
    for (const IntBlockMap& column : _blockCols) count += column.size();
    return count;
  }

  /// Returns a copy, which the caller owns.
  SparseBlockMatrix* clone() const {
    auto* copy = new SparseBlockMatrix(_rowBlockIndices.data(), _colBlockIndices.data(),
                                       static_cast<int>(_rowBlockIndices.size()),
                                       static_cast<int>(_colBlockIndices.size()));
    for_each([&](int r, int c, const SparseMatrixBlock& b) { *copy->block(r, c, true) = b; });
    return copy;
  }
  /// Returns a new matrix with the block rows [rmin, rmax) and block columns [cmin, cmax). The caller owns
  /// the new matrix. If `alloc` is true, the new matrix has copies of the blocks. Otherwise, it shares the
  /// blocks of this matrix.
  SparseBlockMatrix* slice(int rmin, int rmax, int cmin, int cmax, bool alloc = true) const {
    std::vector<int> rowEnds, colEnds;
    for (int r = rmin; r < rmax; ++r)
      rowEnds.push_back(rowBaseOfBlock(r) + rowsOfBlock(r) - rowBaseOfBlock(rmin));
    for (int c = cmin; c < cmax; ++c)
      colEnds.push_back(colBaseOfBlock(c) + colsOfBlock(c) - colBaseOfBlock(cmin));
    auto* part = new SparseBlockMatrix(rowEnds.data(), colEnds.data(), rmax - rmin, cmax - cmin, alloc);
    for (int c = cmin; c < cmax; ++c) {
      const IntBlockMap& column = _blockCols[static_cast<size_t>(c)];
      for (auto it = column.lower_bound(rmin); it != column.end() && it->first < rmax; ++it) {
        SparseMatrixBlock* b = alloc ? new SparseMatrixBlock(*it->second) : it->second;
        part->_blockCols[static_cast<size_t>(c - cmin)].emplace(it->first - rmin, b);
      }
    }
    return part;
  }

  /// Sets dest = thisᵀ. Returns false if the block sizes of `dest` do not match.
  template <class MatrixTransposedType>
  bool transpose(SparseBlockMatrix<MatrixTransposedType>& dest) const {
    if (dest.rowBlockIndices() != _colBlockIndices || dest.colBlockIndices() != _rowBlockIndices)
      return false;
    for_each([&](int r, int c, const SparseMatrixBlock& b) { *dest.block(c, r, true) = b.transpose(); });
    return true;
  }
  bool transpose(SparseBlockMatrix*& dest) const {
    if (dest == nullptr) dest = transposed().release();
    return transpose(*dest);
  }
  /// Returns a new matrix with blocks of type MatrixTransposedType.
  template <class MatrixTransposedType = MatrixType>
  std::unique_ptr<SparseBlockMatrix<MatrixTransposedType>> transposed() const {
    auto result = std::make_unique<SparseBlockMatrix<MatrixTransposedType>>(
        _colBlockIndices.data(), _rowBlockIndices.data(), static_cast<int>(_colBlockIndices.size()),
        static_cast<int>(_rowBlockIndices.size()));
    transpose(*result);
    return result;
  }

  /// Adds this matrix to `dest`. Returns false if the block sizes differ.
  bool add(SparseBlockMatrix& dest) const {
    if (dest._rowBlockIndices != _rowBlockIndices || dest._colBlockIndices != _colBlockIndices) return false;
    for_each([&](int r, int c, const SparseMatrixBlock& b) { *dest.block(r, c, true) += b; });
    return true;
  }
  bool add(SparseBlockMatrix*& dest) const {
    if (dest == nullptr) {
      dest = clone();
      return true;
    }
    return add(*dest);
  }
  std::unique_ptr<SparseBlockMatrix> added() const { return std::unique_ptr<SparseBlockMatrix>(clone()); }

  /// Adds this · M to `dest`. Returns false if the block sizes do not match.
  template <class MatrixResultType, class MatrixFactorType>
  bool multiply(SparseBlockMatrix<MatrixResultType>*& dest,
                const SparseBlockMatrix<MatrixFactorType>* M) const {
    if (M == nullptr || _colBlockIndices != M->rowBlockIndices()) return false;
    if (dest == nullptr) {
      dest = new SparseBlockMatrix<MatrixResultType>(_rowBlockIndices.data(), M->colBlockIndices().data(),
                                                     static_cast<int>(_rowBlockIndices.size()),
                                                     static_cast<int>(M->colBlockIndices().size()));
    }
    if (dest->rowBlockIndices() != _rowBlockIndices || dest->colBlockIndices() != M->colBlockIndices())
      return false;
    for (size_t c = 0; c < M->blockCols().size(); ++c) {
      for (const auto& right : M->blockCols()[c]) {
        for (const auto& left : _blockCols[static_cast<size_t>(right.first)]) {
          *dest->block(left.first, static_cast<int>(c), true) += *left.second * *right.second;
        }
      }
    }
    return true;
  }

  /// Adds this · src to `dest`. If `dest` is null, allocates it with new[].
  void multiply(double*& dest, const double* src) const {
    allocate(dest, rows());
    for_each([&](int r, int c, const SparseMatrixBlock& b) {
      Eigen::Map<VectorX>(dest + rowBaseOfBlock(r), b.rows()) +=
          b * Eigen::Map<const VectorX>(src + colBaseOfBlock(c), b.cols());
    });
  }
  /// Adds A · src to `dest` for a symmetric A. This matrix stores only the upper triangle of the blocks of A.
  void multiplySymmetricUpperTriangle(double*& dest, const double* src) const {
    allocate(dest, rows());
    for_each([&](int r, int c, const SparseMatrixBlock& b) {
      if (r > c) return;
      Eigen::Map<VectorX>(dest + rowBaseOfBlock(r), b.rows()) +=
          b * Eigen::Map<const VectorX>(src + colBaseOfBlock(c), b.cols());
      if (r == c) return;
      Eigen::Map<VectorX>(dest + colBaseOfBlock(c), b.cols()) +=
          b.transpose() * Eigen::Map<const VectorX>(src + rowBaseOfBlock(r), b.rows());
    });
  }
  /// Adds thisᵀ · src to `dest`.
  void rightMultiply(double*& dest, const double* src) const {
    allocate(dest, cols());
    for_each([&](int r, int c, const SparseMatrixBlock& b) {
      Eigen::Map<VectorX>(dest + colBaseOfBlock(c), b.cols()) +=
          b.transpose() * Eigen::Map<const VectorX>(src + rowBaseOfBlock(r), b.rows());
    });
  }
  void scale(double a) {
    for (IntBlockMap& column : _blockCols) {
      for (auto& entry : column) *entry.second *= a;
    }
  }

  /// Sets dest = P · this · Pᵀ for a symmetric matrix. Block row and column i become block row and column
  /// pinv[i]. If `onlyUpper` is true, both matrices store only their upper triangle of blocks. Returns false
  /// if the block sizes of `dest` do not match.
  bool symmPermutation(SparseBlockMatrix*& dest, const int* pinv, bool onlyUpper = false) const {
    const size_t n = _rowBlockIndices.size();
    std::vector<int> ends(n);
    for (size_t i = 0; i < n; ++i) ends[static_cast<size_t>(pinv[i])] = rowsOfBlock(static_cast<int>(i));
    for (size_t i = 1; i < n; ++i) ends[i] += ends[i - 1];
    if (dest == nullptr) {
      dest = new SparseBlockMatrix(ends.data(), ends.data(), static_cast<int>(n), static_cast<int>(n));
    }
    if (dest->_rowBlockIndices != ends || dest->_colBlockIndices != ends) return false;
    dest->clear();
    for_each([&](int r, int c, const SparseMatrixBlock& b) {
      const int pr = pinv[r], pc = pinv[c];
      if (onlyUpper && pr > pc) {
        *dest->block(pc, pr, true) = b.transpose();
      } else {
        *dest->block(pr, pc, true) = b;
      }
    });
    return true;
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
  /// Writes the sparsity pattern of the upper triangle of blocks to `ms`.
  void fillBlockStructure(MatrixStructure& ms) const {
    int count = 0;
    for (size_t c = 0; c < _blockCols.size(); ++c)
      for (const auto& entry : _blockCols[c]) count += entry.first <= static_cast<int>(c);
    ms.alloc(static_cast<int>(_colBlockIndices.size()), count);
    ms.m = static_cast<int>(_rowBlockIndices.size());
    fillBlockStructure(ms.Ap, ms.Aii);
  }
  int fillBlockStructure(int* Cp, int* Ci) const {
    int count = 0;
    for (size_t c = 0; c < _blockCols.size(); ++c) {
      Cp[c] = count;
      for (const auto& entry : _blockCols[c]) {
        if (entry.first <= static_cast<int>(c)) Ci[count++] = entry.first;
      }
    }
    Cp[_blockCols.size()] = count;
    return count;
  }

  /// Fills `blockCCS` with pointers to the blocks of this matrix. `blockCCS` must have the same block
  /// boundaries. Returns the number of blocks.
  int fillSparseBlockMatrixCCS(SparseBlockMatrixCCS<MatrixType>& blockCCS) const {
    auto& columns = blockCCS.blockCols();
    columns.assign(_blockCols.size(), {});
    for_each_block(
        [&](int r, int c, SparseMatrixBlock* b) { columns[static_cast<size_t>(c)].emplace_back(r, b); });
    return static_cast<int>(nonZeroBlocks());
  }
  /// Fills `blockCCS` with pointers to the blocks of this matrix: block row r of this matrix becomes column r
  /// of `blockCCS`. The blocks themselves are not transposed.
  int fillSparseBlockMatrixCCSTransposed(SparseBlockMatrixCCS<MatrixType>& blockCCS) const {
    auto& columns = blockCCS.blockCols();
    columns.assign(_rowBlockIndices.size(), {});
    for_each_block(
        [&](int r, int c, SparseMatrixBlock* b) { columns[static_cast<size_t>(r)].emplace_back(c, b); });
    return static_cast<int>(nonZeroBlocks());
  }
  /// Replaces the blocks of this matrix by the blocks of `hashMatrix`, which must have the same block
  /// boundaries. Afterwards, `hashMatrix` is empty.
  void takePatternFromHash(SparseBlockMatrixHashMap<MatrixType>& hashMatrix) {
    clear(true);
    _blockCols.resize(_colBlockIndices.size());
    for (size_t c = 0; c < hashMatrix.blockCols().size(); ++c) {
      auto& from = hashMatrix.blockCols()[c];
      _blockCols[c].insert(from.begin(), from.end());
      from.clear();
    }
  }

  /// Writes the matrix to a file for Octave. If `upperTriangle` is true, the matrix must store only its upper
  /// triangle. The file then also contains the mirrored lower triangle.
  bool writeOctave(const char* filename, bool upperTriangle = true) const {
    std::ofstream out(filename);
    if (!out) return false;
    std::map<std::pair<int, int>, double> entries;  // keys: (column, row)
    for_each([&](int r, int c, const SparseMatrixBlock& b) {
      for (int i = 0; i < b.rows(); ++i) {
        for (int j = 0; j < b.cols(); ++j) {
          const int row = rowBaseOfBlock(r) + i, column = colBaseOfBlock(c) + j;
          entries[{column, row}] = b(i, j);
          if (upperTriangle && r != c) entries[{row, column}] = b(i, j);
        }
      }
    });
    out << "# name: matrix\n# type: sparse matrix\n# nnz: " << entries.size() << "\n# rows: " << rows()
        << "\n# columns: " << cols() << "\n"
        << std::setprecision(17);
    for (const auto& [at, value] : entries)
      out << at.second + 1 << " " << at.first + 1 << " " << value << "\n";
    return out.good();
  }

  const std::vector<IntBlockMap>& blockCols() const { return _blockCols; }
  std::vector<IntBlockMap>& blockCols() { return _blockCols; }
  const std::vector<int>& rowBlockIndices() const { return _rowBlockIndices; }
  std::vector<int>& rowBlockIndices() { return _rowBlockIndices; }
  const std::vector<int>& colBlockIndices() const { return _colBlockIndices; }
  std::vector<int>& colBlockIndices() { return _colBlockIndices; }

 protected:
  std::vector<int> _rowBlockIndices;
  std::vector<int> _colBlockIndices;
  std::vector<IntBlockMap> _blockCols;
  bool _hasStorage;

 private:
  static void allocate(double*& dest, int count) {
    if (dest == nullptr) dest = new double[static_cast<size_t>(count)]();
  }
  void swap(SparseBlockMatrix& other) noexcept {
    _rowBlockIndices.swap(other._rowBlockIndices);
    _colBlockIndices.swap(other._colBlockIndices);
    _blockCols.swap(other._blockCols);
    std::swap(_hasStorage, other._hasStorage);
  }
  template <class F>
  void for_each_block(F&& f) const {
    for (size_t c = 0; c < _blockCols.size(); ++c) {
      for (const auto& entry : _blockCols[c]) f(entry.first, static_cast<int>(c), entry.second);
    }
  }
  template <class F>
  void for_each(F&& f) const {
    for_each_block([&](int r, int c, const SparseMatrixBlock* b) { f(r, c, *b); });
  }
  /// Returns the argument `visit` of internal::fillCCS().
  auto scalars(bool upperTriangle) const {
    return [this, upperTriangle](auto&& begin, auto&& take) {
      internal::visitScalars(
          _blockCols, _rowBlockIndices, _colBlockIndices, upperTriangle,
          [](const auto& entry) { return entry.first; },
          [](const auto& entry) -> const SparseMatrixBlock& { return *entry.second; }, begin, take);
    };
  }
};

template <class MatrixType>
std::ostream& operator<<(std::ostream& os, const SparseBlockMatrix<MatrixType>& m) {
  os << "RBI: " << m.rowBlockIndices().size();
  for (int end : m.rowBlockIndices()) os << " " << end;
  os << "\nCBI: " << m.colBlockIndices().size();
  for (int end : m.colBlockIndices()) os << " " << end;
  os << "\n";
  for (size_t c = 0; c < m.blockCols().size(); ++c) {
    for (const auto& entry : m.blockCols()[c])
      os << "BLOCK: " << entry.first << " " << c << "\n" << *entry.second << "\n";
  }
  return os;
}

using SparseBlockMatrixX = SparseBlockMatrix<MatrixX>;
using SparseBlockMatrixXd = SparseBlockMatrix<MatrixX>;
using SparseBlockMatrixXD = SparseBlockMatrix<MatrixX>;

}  // namespace g2o

#endif  // G2O_SPARSE_BLOCK_MATRIX_
