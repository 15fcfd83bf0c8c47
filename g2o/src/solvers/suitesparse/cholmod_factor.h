// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cholmod.h>

#include <vector>

#include "solvers/suitesparse/sparse_factor.h"

namespace g2o {
namespace internal {

/// A Cholesky factor that CHOLMOD computes. CHOLMOD chooses between a simplicial and a supernodal
/// factorization.
class CholmodFactor {
 public:
  CholmodFactor();
  CholmodFactor(const CholmodFactor&) = delete;
  CholmodFactor& operator=(const CholmodFactor&) = delete;
  ~CholmodFactor();

  bool analyze(UpperTriangle& A, const std::vector<int>& order);
  bool factorize(UpperTriangle& A);
  bool solve(const double* b, double* x);
  LowerFactor lower();
  size_t nonZeros() const { return static_cast<size_t>(common_.lnz); }

 private:
  cholmod_common common_;
  cholmod_factor* factor_ = nullptr;
  cholmod_factor* simplicial_ = nullptr;  // a simplicial copy of factor_ for lower()
  std::vector<int> place_;
};

}  // namespace internal
}  // namespace g2o
