// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/suitesparse/cholmod_factor.h"

namespace g2o {
namespace internal {

namespace {

/// A read-only view of the matrix for CHOLMOD.
cholmod_sparse view(UpperTriangle& A) {
  constexpr int kUpper = 1;
  cholmod_sparse m{};
  m.nrow = m.ncol = static_cast<size_t>(A.n);
  m.nzmax = A.i.size();
  m.p = A.p.data();
  m.i = A.i.data();
  m.x = A.x.data();
  m.stype = kUpper;
  m.itype = CHOLMOD_INT;
  m.xtype = CHOLMOD_REAL;
  m.dtype = CHOLMOD_DOUBLE;
  m.sorted = m.packed = 1;
  return m;
}

}  // namespace

CholmodFactor::CholmodFactor() {
  cholmod_start(&common_);
  common_.print = 0;
  common_.nmethods = 1;
  common_.final_ll = 1;  // always LLᵀ, because LDLᵀ would accept indefinite matrices
}

CholmodFactor::~CholmodFactor() {
  cholmod_free_factor(&simplicial_, &common_);
  cholmod_free_factor(&factor_, &common_);
  cholmod_finish(&common_);
}

bool CholmodFactor::analyze(UpperTriangle& A, const std::vector<int>& order) {
  cholmod_free_factor(&factor_, &common_);
  cholmod_sparse matrix = view(A);
  common_.method[0].ordering = order.empty() ? CHOLMOD_AMD : CHOLMOD_GIVEN;
  std::vector<int> given = order;
  factor_ = cholmod_analyze_p(&matrix, given.empty() ? nullptr : given.data(), nullptr, 0, &common_);
  return factor_ != nullptr && common_.status == CHOLMOD_OK;
}

bool CholmodFactor::factorize(UpperTriangle& A) {
  cholmod_free_factor(&simplicial_, &common_);
  cholmod_sparse matrix = view(A);
  cholmod_factorize(&matrix, factor_, &common_);
  return common_.status == CHOLMOD_OK && factor_->minor == factor_->n;
}

bool CholmodFactor::solve(const double* b, double* x) {
  const size_t n = factor_->n;
  cholmod_dense right{};
  right.nrow = right.nzmax = right.d = n;
  right.ncol = 1;
  right.x = const_cast<double*>(b);  // CHOLMOD only reads b
  right.xtype = CHOLMOD_REAL;
  right.dtype = CHOLMOD_DOUBLE;
  cholmod_dense* solution = cholmod_solve(CHOLMOD_A, factor_, &right, &common_);
  if (solution == nullptr) return false;
  std::copy_n(static_cast<const double*>(solution->x), n, x);
  cholmod_free_dense(&solution, &common_);
  return true;
}

LowerFactor CholmodFactor::lower() {
  if (simplicial_ == nullptr) {
    simplicial_ = cholmod_copy_factor(factor_, &common_);
    constexpr int kLL = 1, kSupernodal = 0, kPacked = 1, kMonotonic = 1;
    if (simplicial_ == nullptr || cholmod_change_factor(CHOLMOD_REAL, kLL, kSupernodal, kPacked, kMonotonic,
                                                        simplicial_, &common_) == 0)
      return {};
  }
  const auto* permutation = static_cast<const int*>(simplicial_->Perm);
  place_.resize(simplicial_->n);
  for (size_t k = 0; k < place_.size(); ++k)
    place_[static_cast<size_t>(permutation[k])] = static_cast<int>(k);
  return {static_cast<int*>(simplicial_->p), static_cast<int*>(simplicial_->i),
          static_cast<double*>(simplicial_->x), place_.data()};
}

}  // namespace internal
}  // namespace g2o
