// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/optimization_algorithm_gauss_newton.h"

#include <ostream>

#include "core/refused_steps.h"
#include "g2o/core/sparse_optimizer.h"

namespace g2o {

OptimizationAlgorithmGaussNewton::OptimizationAlgorithmGaussNewton(std::unique_ptr<Solver> solver)
    : OptimizationAlgorithmWithHessian(solver.release()) {}

OptimizationAlgorithmGaussNewton::OptimizationAlgorithmGaussNewton(Solver* solver)
    : OptimizationAlgorithmGaussNewton(std::unique_ptr<Solver>(solver)) {}

OptimizationAlgorithmGaussNewton::~OptimizationAlgorithmGaussNewton() = default;

OptimizationAlgorithm::SolverResult OptimizationAlgorithmGaussNewton::solve(int iteration, bool online) {
  if (!linearize(iteration, online) || !solveSystem()) return Fail;
  return internal::update(*_optimizer, _solver.x()) ? OK : Fail;
}

void OptimizationAlgorithmGaussNewton::printVerbose(std::ostream& os) const {
  os << "\t schur= " << _solver.schur();
}

}  // namespace g2o
