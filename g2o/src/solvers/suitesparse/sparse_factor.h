// SPDX-License-Identifier: BSD-3-Clause
// A LinearSolver that uses the sparse Cholesky factorization of another library.
#pragma once

#include <amd.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "g2o/core/batch_stats.h"
#include "g2o/core/linear_solver.h"
#include "g2o/core/marginal_covariance_cholesky.h"
#include "g2o/stuff/timeutil.h"

namespace g2o {
namespace internal {

/// The upper triangle of a symmetric matrix in compressed columns. The rows of each column are in ascending
/// order.
struct UpperTriangle {
  int n = 0;
  std::vector<int> p, i;
  std::vector<double> x;
};

/// The factor L in compressed columns. Each column begins with its diagonal entry. `place[k]` is the row of L
/// for row k of the matrix. If `place` is null, the rows of L and of the matrix have the same order.
struct LowerFactor {
  int *p = nullptr, *i = nullptr;
  double* x = nullptr;
  int* place = nullptr;
};

/// The class Factor must have these members:
///   bool analyze(UpperTriangle&, const std::vector<int>& order)   chooses an order if `order` is empty
///   bool factorize(UpperTriangle&)                                false if not positive definite
///   bool solve(const double* b, double* x)
///   LowerFactor lower()                                           valid until the next factorize()
///   size_t nonZeros() const
template <class MatrixType, class Factor>
class SparseFactorSolver : public LinearSolverCCS<MatrixType> {
 public:
  bool init() override {
    analyzed_ = false;
    return true;
  }
  bool solve(const SparseBlockMatrix<MatrixType>& A, double* x, double* b) override {
    return factorize(A) && factor_.solve(b, x);
  }
  bool solveBlocks(double**& blocks, const SparseBlockMatrix<MatrixType>& A) override {
    MarginalCovarianceCholesky inverse;
    if (!factorize(A) || !invert(inverse)) return false;
    if (blocks == nullptr) this->allocateBlocks(A, blocks);
    inverse.computeCovariance(blocks, A.rowBlockIndices());
    return true;
  }
  bool solvePattern(SparseBlockMatrix<MatrixX>& spinv, const std::vector<std::pair<int, int>>& blockIndices,
                    const SparseBlockMatrix<MatrixType>& A) override {
    MarginalCovarianceCholesky inverse;
    if (!factorize(A) || !invert(inverse)) return false;
    inverse.computeCovariance(spinv, A.rowBlockIndices(), blockIndices);
    return true;
  }

 private:
  bool factorize(const SparseBlockMatrix<MatrixType>& A) {
    G2OBatchStatistics* statistics = G2OBatchStatistics::globalStats();
    if (load(A) || !analyzed_ || ordered_by_blocks_ != this->blockOrdering()) {
      const internal::AddedTime time(statistics ? &statistics->timeSymbolicDecomposition : nullptr);
      ordered_by_blocks_ = this->blockOrdering();
      analyzed_ = factor_.analyze(upper_, ordered_by_blocks_ ? blockOrder(A) : std::vector<int>());
      if (!analyzed_) return false;
    }
    const internal::AddedTime time(statistics ? &statistics->timeNumericDecomposition : nullptr);
    const bool ok = factor_.factorize(upper_);
    if (ok && statistics != nullptr) statistics->choleskyNNZ = factor_.nonZeros();
    return ok;
  }

  /// Loads a matrix. Returns true if its pattern has changed.
  bool load(const SparseBlockMatrix<MatrixType>& A) {
    std::vector<int> pattern = pattern_of(A);
    const bool changed = pattern != pattern_;
    if (changed) {
      pattern_ = std::move(pattern);
      upper_.n = A.cols();
      upper_.p.resize(static_cast<size_t>(upper_.n) + 1);
      upper_.i.resize(A.nonZeros());
      upper_.x.resize(A.nonZeros());
      const auto count =
          static_cast<size_t>(A.fillCCS(upper_.p.data(), upper_.i.data(), upper_.x.data(), true));
      upper_.i.resize(count);
      upper_.x.resize(count);
    } else {
      load_values(A);
    }
    return changed;
  }

  /// Returns the boundaries of the block columns, and then, for each block column, the number of its blocks
  /// and their block rows.
  static std::vector<int> pattern_of(const SparseBlockMatrix<MatrixType>& A) {
    std::vector<int> pattern = A.colBlockIndices();
    for (const auto& column : A.blockCols()) {
      pattern.push_back(static_cast<int>(column.size()));
      for (const auto& [row, block] : column) pattern.push_back(row);
    }
    return pattern;
  }

  /// Loads the values of a matrix whose pattern is already loaded. In each column, the entries of a block
  /// follow the entries of the blocks above it.
  void load_values(const SparseBlockMatrix<MatrixType>& A) {
    const int* begin = upper_.p.data();
    for (size_t c = 0; c < A.blockCols().size(); ++c) {
      Eigen::Index above = 0;
      for (const auto& [row, block] : A.blockCols()[c]) {
        if (row > static_cast<int>(c)) break;
        const bool diagonal = row == static_cast<int>(c);
        for (Eigen::Index j = 0; j < block->cols(); ++j)
          std::copy_n(&block->coeffRef(0, j), diagonal ? j + 1 : block->rows(),
                      upper_.x.data() + begin[j] + above);
        above += block->rows();
      }
      begin += A.colsOfBlock(static_cast<int>(c));
    }
  }

  /// Returns a minimum-degree order of the blocks, expanded to scalars.
  std::vector<int> blockOrder(const SparseBlockMatrix<MatrixType>& A) const {
    const auto blocks = static_cast<int>(A.colBlockIndices().size());
    std::vector<int> p(static_cast<size_t>(blocks) + 1), i(A.nonZeroBlocks());
    A.fillBlockStructure(p.data(), i.data());
    Eigen::VectorXi order(blocks), scalars(A.cols());
    if (amd_order(blocks, p.data(), i.data(), order.data(), nullptr, nullptr) < 0) return {};
    this->blockToScalarPermutation(A, order, scalars);
    return {scalars.data(), scalars.data() + scalars.size()};
  }

  bool invert(MarginalCovarianceCholesky& inverse) {
    const LowerFactor L = factor_.lower();
    if (L.p == nullptr) return false;
    inverse.setCholeskyFactor(upper_.n, L.p, L.i, L.x, L.place);
    return true;
  }

  std::vector<int> pattern_;  // the block pattern of upper_
  UpperTriangle upper_;
  Factor factor_;
  bool analyzed_ = false;
  bool ordered_by_blocks_ = false;
};

}  // namespace internal
}  // namespace g2o
