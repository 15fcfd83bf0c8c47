// SPDX-License-Identifier: BSD-3-Clause
// Functions that factorize matrices and solve linear systems with CSparse, given a symbolic analysis. Only
// this header needs CXSparse (LGPL), to compile and to link. No other header includes this header.
#pragma once
#ifndef G2O_CSPARSE_HELPER_H
#define G2O_CSPARSE_HELPER_H

#if defined(__has_include) && __has_include(<suitesparse/cs.h>)
#include <suitesparse/cs.h>
#else
#include <cs.h>
#endif

#include <string>

#include "g2o/stuff/sparse_helper.h"

namespace g2o {
namespace csparse_extension {

/// Returns the Cholesky factor of a symmetric A, which is given by its upper triangle. S is the symbolic
/// analysis of A. Returns nullptr if A is not positive definite. The caller frees the factor. `cin` and `xin`
/// are not used, because CSparse has an internal workspace.
inline cs_din* cs_chol_workspace(const cs_di* A, const cs_dis* S, int* cin, double* xin) {
  static_cast<void>(cin);
  static_cast<void>(xin);
  return cs_di_chol(A, S);
}

/// Replaces b by A⁻¹ b. S is the symbolic analysis of A. `workspace` must have one double per column of A.
/// `work` is not used. Returns false if A is not positive definite.
inline bool cs_cholsolsymb(const cs_di* A, double* b, const cs_dis* S, double* workspace, int* work) {
  cs_din* factor = cs_chol_workspace(A, S, work, workspace);
  const bool ok = factor != nullptr && cs_di_ipvec(S->pinv, b, workspace, A->n) != 0 &&
                  cs_di_lsolve(factor->L, workspace) != 0 && cs_di_ltsolve(factor->L, workspace) != 0 &&
                  cs_di_pvec(S->pinv, workspace, b, A->n) != 0;
  cs_di_nfree(factor);
  return ok;
}

/// Writes a matrix to a file for Octave. See writeCCSMatrix().
inline bool writeCs2Octave(const char* filename, const cs_di* A, bool upperTriangular = true) {
  return writeCCSMatrix(filename, A->m, A->n, A->p, A->i, A->x, upperTriangular);
}

}  // namespace csparse_extension
}  // namespace g2o

#endif  // G2O_CSPARSE_HELPER_H
