// SPDX-License-Identifier: BSD-3-Clause
// Facts about the analysis and the factor of a linear solver, for reports.
#pragma once

#include <cstdint>

#include "boxplus/linear/linear_solver_kind.h"

namespace boxplus {

struct LinearStatistics {
  std::uint64_t factor_nonzeros = 0;  ///< number of scalars in L, including the zeros that amalgamation adds
  double factor_flops = 0;            ///< number of useful floating-point operations in one factorization
  std::uint32_t supernodes = 0;
  std::uint32_t largest_front = 0;  ///< rows of the largest frontal matrix, in scalars
  double factor_seconds = 0;        ///< predicted time of one factorization on one thread
  /// LinearSolverKind::kAutomatic: the predicted time of one rough solution by pcg on one thread.
  double pcg_seconds = 0;
  /// If LinearSolverKind::kAutomatic chose pcg, the memory that a Cholesky factor would have taken; otherwise
  /// 0. kAutomatic chooses pcg if a factor takes too much memory, or if a factorization takes far longer than
  /// pcg.
  std::uint64_t refused_factor_bytes = 0;
  Ordering ordering = Ordering::kMinimumDegree;  ///< of the blocks, if the solver orders them
  Precision precision = Precision::kDouble;      ///< of the factor in use
  int workers = 1;                               ///< number of threads that factorize
  bool fell_back_to_double = false;              ///< the float factor did not converge or was not faster
};

}  // namespace boxplus
