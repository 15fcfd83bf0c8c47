// SPDX-License-Identifier: BSD-3-Clause
// A sparse Cholesky of another library as a LinearSolver.
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

/// The upper triangle of a symmetric matrix in compressed columns, rows ascending.
struct UpperTriangle {
  int n = 0;
  std::vector<int> p, i;
  std::vector<double> x;
};

/// L in compressed columns, the diagonal first; `place`: where each scalar of the matrix stands in it, or
/// null.
struct LowerFactor {
  int *p = nullptr, *i = nullptr;
  double* x = nullptr;
  int* place = nullptr;
};

/// Factor has:
///   bool analyze(const UpperTriangle&, const std::vector<int>& order)   empty: an order of its own choice
///   bool factorize(const UpperTriangle&)                                false: not positive definite
///   bool solve(const double* b, double* x)
///   LowerFactor lower()                                                 until the next factorize()
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

  /// Whether the pattern is another one than before.
  bool load(const SparseBlockMatrix<MatrixType>& A) {
    UpperTriangle next;
    next.n = A.cols();
    next.p.resize(static_cast<size_t>(next.n) + 1);
    next.i.resize(A.nonZeros());
    next.x.resize(A.nonZeros());
    const auto count = static_cast<size_t>(A.fillCCS(next.p.data(), next.i.data(), next.x.data(), true));
    next.i.resize(count);
    next.x.resize(count);
    const bool changed = next.p != upper_.p || next.i != upper_.i;
    upper_ = std::move(next);
    return changed;
  }

  /// Minimum degree of the blocks, as an order of scalars.
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

  UpperTriangle upper_;
  Factor factor_;
  bool analyzed_ = false;
  bool ordered_by_blocks_ = false;
};

}  // namespace internal
}  // namespace g2o
