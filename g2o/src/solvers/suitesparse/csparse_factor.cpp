// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/suitesparse/csparse_factor.h"

namespace g2o {
namespace internal {
namespace {

constexpr int kCompressed = -1;    // marks a cs_di with compressed columns instead of triplets
constexpr int kMinimumDegree = 1;  // selects a minimum-degree order of A + Aᵀ

/// A read-only view of the matrix for CSparse.
cs_di view(const UpperTriangle& A) {
  cs_di m{};
  m.nzmax = static_cast<int>(A.i.size());
  m.m = m.n = A.n;
  m.p = const_cast<int*>(A.p.data());
  m.i = const_cast<int*>(A.i.data());
  m.x = const_cast<double*>(A.x.data());
  m.nz = kCompressed;
  return m;
}

/// Analyzes the matrix in a given order: computes the elimination tree and the column counts of the permuted
/// matrix.
cs_dis* analyze_in_order(const cs_di& A, const std::vector<int>& order) {
  auto* S = static_cast<cs_dis*>(cs_di_calloc(1, sizeof(cs_dis)));
  if (S == nullptr) return nullptr;
  S->pinv = cs_di_pinv(order.data(), A.n);
  cs_di* permuted = cs_di_symperm(&A, S->pinv, 0);
  S->parent = cs_di_etree(permuted, 0);
  int* post = cs_di_post(S->parent, A.n);
  int* counts = cs_di_counts(permuted, S->parent, post, 0);
  S->cp = static_cast<int*>(cs_di_malloc(A.n + 1, sizeof(int)));
  const bool ok = S->cp != nullptr && counts != nullptr;
  if (ok) S->unz = S->lnz = cs_di_cumsum(S->cp, counts, A.n);
  cs_di_free(counts);
  cs_di_free(post);
  cs_di_spfree(permuted);
  return ok ? S : cs_di_sfree(S);
}

}  // namespace

CSparseFactor::~CSparseFactor() {
  cs_di_nfree(numeric_);
  cs_di_sfree(symbolic_);
}

bool CSparseFactor::analyze(const UpperTriangle& A, const std::vector<int>& order) {
  symbolic_ = cs_di_sfree(symbolic_);
  const cs_di matrix = view(A);
  symbolic_ = order.empty() ? cs_di_schol(kMinimumDegree, &matrix) : analyze_in_order(matrix, order);
  work_.resize(static_cast<size_t>(A.n));
  return symbolic_ != nullptr;
}

bool CSparseFactor::factorize(const UpperTriangle& A) {
  numeric_ = cs_di_nfree(numeric_);
  const cs_di matrix = view(A);
  numeric_ = cs_di_chol(&matrix, symbolic_);
  return numeric_ != nullptr;
}

bool CSparseFactor::solve(const double* b, double* x) {
  const auto n = static_cast<int>(work_.size());
  return cs_di_ipvec(symbolic_->pinv, b, work_.data(), n) != 0 &&
         cs_di_lsolve(numeric_->L, work_.data()) != 0 && cs_di_ltsolve(numeric_->L, work_.data()) != 0 &&
         cs_di_pvec(symbolic_->pinv, work_.data(), x, n) != 0;
}

}  // namespace internal
}  // namespace g2o
