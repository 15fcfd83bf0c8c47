// SPDX-License-Identifier: BSD-3-Clause
// Preconditioned conjugate gradients (Hestenes and Stiefel 1952).
#pragma once

#include <cstddef>
#include <vector>

#include "boxplus/base/function_ref.h"
#include "boxplus/linear/linear_solver.h"

namespace boxplus {

class ConjugateGradients {
 public:
  /// Computes y = A x, or y = M⁻¹ x with the preconditioner M.
  using Operator = detail::FunctionRef<void(const double* x, double* y)>;

  void resize(std::size_t size);
  /// Solves A x = b from x = 0. x may be b. If the result is not kOk, x is the last iterate.
  SolveResult solve(Operator multiply, Operator precondition, const double* b, double* x,
                    const SolveControl& control);

 private:
  SolveResult iterate(Operator multiply, Operator precondition, double target, int& iterations_left,
                      const StopToken& stop);
  SolveResult solve_into_x(Operator multiply, Operator precondition, const double* b,
                           const SolveControl& control);

  std::vector<double> b_, x_, r_, z_, p_, q_;
};

}  // namespace boxplus
