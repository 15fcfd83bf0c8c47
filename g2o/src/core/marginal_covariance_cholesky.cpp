// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/marginal_covariance_cholesky.h"

#include <algorithm>

#include "g2o/core/block_layout.h"

namespace g2o {

MarginalCovarianceCholesky::MarginalCovarianceCholesky() = default;
MarginalCovarianceCholesky::~MarginalCovarianceCholesky() = default;

void MarginalCovarianceCholesky::setCholeskyFactor(int n, int* Lp, int* Li, double* Lx, int* permInv) {
  _n = n;
  _Ap = Lp;
  _Ai = Li;
  _Ax = Lx;
  _perm = permInv;
  inverse_.clear();
  columns_.clear();
}

/// Computes the entries of Z = L⁻ᵀ L⁻¹ on the pattern of L, from the last column to the first: Z_ij = −Σ_k
/// Z_ik L_kj / L_jj and Z_jj = (1 / L_jj − Σ_k L_kj Z_kj) / L_jj. Here i and k are rows below the diagonal in
/// which column j has entries. For all such i and k, the pattern of L contains the entry (i, k), too.
void MarginalCovarianceCholesky::sweep() {
  inverse_.assign(static_cast<size_t>(_Ap[_n]), 0.0);
  std::vector<int> place(static_cast<size_t>(_n), -1);  // the position of each row in column j, or -1
  std::vector<double> sums;
  for (int j = _n - 1; j >= 0; --j) {
    const int first = _Ap[j] + 1, count = _Ap[j + 1] - first;
    sums.assign(static_cast<size_t>(count), 0.0);
    for (int p = 0; p < count; ++p) place[static_cast<size_t>(_Ai[first + p])] = p;
    for (int p = 0; p < count; ++p) {
      const int k = _Ai[first + p];
      sums[static_cast<size_t>(p)] += _Ax[first + p] * inverse_[static_cast<size_t>(_Ap[k])];
      for (int q = _Ap[k] + 1; q < _Ap[k + 1]; ++q) {
        const int i = place[static_cast<size_t>(_Ai[q])];
        if (i < 0) continue;
        sums[static_cast<size_t>(i)] += _Ax[first + p] * inverse_[static_cast<size_t>(q)];
        sums[static_cast<size_t>(p)] += _Ax[first + i] * inverse_[static_cast<size_t>(q)];
      }
    }
    const double diagonal = _Ax[_Ap[j]];
    double sum = 1 / diagonal;
    for (int p = 0; p < count; ++p) {
      const double z = -sums[static_cast<size_t>(p)] / diagonal;
      inverse_[static_cast<size_t>(first + p)] = z;
      sum -= _Ax[first + p] * z;
      place[static_cast<size_t>(_Ai[first + p])] = -1;
    }
    inverse_[static_cast<size_t>(_Ap[j])] = sum / diagonal;
  }
}

/// Returns column c of the inverse: the solution z of L Lᵀ z = e_c.
const VectorX& MarginalCovarianceCholesky::column(int c) {
  const auto [found, is_new] = columns_.try_emplace(c);
  VectorX& z = found->second;
  if (!is_new) return z;
  z = VectorX::Unit(_n, c);
  for (int j = c; j < _n; ++j) {
    z[j] /= _Ax[_Ap[j]];
    for (int p = _Ap[j] + 1; p < _Ap[j + 1]; ++p) z[_Ai[p]] -= _Ax[p] * z[j];
  }
  for (int j = _n - 1; j >= 0; --j) {
    for (int p = _Ap[j] + 1; p < _Ap[j + 1]; ++p) z[j] -= _Ax[p] * z[_Ai[p]];
    z[j] /= _Ax[_Ap[j]];
  }
  return z;
}

/// Returns the entry of the inverse of A at a row and a column of A.
double MarginalCovarianceCholesky::entry(int row, int column_of_A) {
  const int a = _perm != nullptr ? _perm[row] : row;
  const int b = _perm != nullptr ? _perm[column_of_A] : column_of_A;
  const int c = std::min(a, b), r = std::max(a, b);
  for (int p = _Ap[c]; p < _Ap[c + 1]; ++p) {
    if (_Ai[p] == r) return inverse_[static_cast<size_t>(p)];
  }
  return column(c)[r];
}

void MarginalCovarianceCholesky::computeCovariance(double** covBlocks, const std::vector<int>& blockIndices) {
  if (inverse_.empty()) sweep();
  for (size_t b = 0; b < blockIndices.size(); ++b) {
    const int base = internal::blockBase(blockIndices, static_cast<int>(b));
    const int dim = internal::blockSize(blockIndices, static_cast<int>(b));
    for (int c = 0; c < dim; ++c) {
      for (int r = 0; r < dim; ++r) covBlocks[b][c * dim + r] = entry(base + r, base + c);
    }
  }
}

void MarginalCovarianceCholesky::computeCovariance(SparseBlockMatrix<MatrixX>& spinv,
                                                   const std::vector<int>& rowBlockIndices,
                                                   const std::vector<std::pair<int, int>>& blockIndices) {
  if (inverse_.empty()) sweep();
  const auto n = static_cast<int>(rowBlockIndices.size());
  spinv = SparseBlockMatrix<MatrixX>(rowBlockIndices.data(), rowBlockIndices.data(), n, n);
  for (const auto& [i, j] : blockIndices) {
    if (i < 0 || j < 0 || i >= n || j >= n) continue;
    MatrixX& block = *spinv.block(i, j, true);
    for (int c = 0; c < block.cols(); ++c) {
      for (int r = 0; r < block.rows(); ++r)
        block(r, c) = entry(spinv.rowBaseOfBlock(i) + r, spinv.colBaseOfBlock(j) + c);
    }
  }
}

}  // namespace g2o
