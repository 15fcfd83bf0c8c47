// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cs.h>

#include <vector>

#include "solvers/suitesparse/sparse_factor.h"

namespace g2o {
namespace internal {

/// A Cholesky factor that CSparse (CXSparse) computes with an up-looking simplicial algorithm.
class CSparseFactor {
 public:
  CSparseFactor() = default;
  CSparseFactor(const CSparseFactor&) = delete;
  CSparseFactor& operator=(const CSparseFactor&) = delete;
  ~CSparseFactor();

  bool analyze(const UpperTriangle& A, const std::vector<int>& order);
  bool factorize(const UpperTriangle& A);
  bool solve(const double* b, double* x);
  LowerFactor lower() { return {numeric_->L->p, numeric_->L->i, numeric_->L->x, symbolic_->pinv}; }
  size_t nonZeros() const { return static_cast<size_t>(symbolic_->lnz); }

 private:
  cs_dis* symbolic_ = nullptr;
  cs_din* numeric_ = nullptr;
  std::vector<double> work_;
};

}  // namespace internal
}  // namespace g2o
