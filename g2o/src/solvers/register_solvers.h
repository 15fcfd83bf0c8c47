// SPDX-License-Identifier: BSD-3-Clause
// Macros that register algorithms in the factory. A call registers all algorithms that use one linear solver.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "g2o/core/block_solver.h"
#include "g2o/core/optimization_algorithm_dogleg.h"
#include "g2o/core/optimization_algorithm_factory.h"
#include "g2o/core/optimization_algorithm_gauss_newton.h"
#include "g2o/core/optimization_algorithm_levenberg.h"

namespace g2o {
namespace internal {

class SolverCreator : public AbstractOptimizationAlgorithmCreator {
 public:
  using Make = std::function<OptimizationAlgorithm*()>;
  SolverCreator(const OptimizationAlgorithmProperty& property, Make make)
      : AbstractOptimizationAlgorithmCreator(property), make_(std::move(make)) {}
  OptimizationAlgorithm* construct() override { return make_(); }

 private:
  Make make_;
};

/// Returns a creator of Algorithm with pose blocks of size p × p and landmark blocks of size l × l. A size of
/// −1 means any size.
template <class Algorithm, template <class> class LinearSolver, int p, int l>
AbstractOptimizationAlgorithmCreator* solver_creator(const std::string& name, const std::string& method,
                                                     const std::string& type) {
  const bool fixed = p > 0;
  const std::string blocks =
      fixed ? "blocks of " + std::to_string(p) + " and " + std::to_string(l) : "blocks of any size";
  const OptimizationAlgorithmProperty property(name, method + ": " + type + ", " + blocks, type, fixed, p, l);
  return new SolverCreator(property, [] {
    using Blocks = BlockSolverPL<p, l>;
    return new Algorithm(
        std::make_unique<Blocks>(std::make_unique<LinearSolver<typename Blocks::PoseMatrixType>>()));
  });
}

}  // namespace internal
}  // namespace g2o

/// G2O_REGISTER_GN_AND_LM registers eight algorithms: Gauss-Newton (prefix gn_) and Levenberg-Marquardt
/// (prefix lm_), each for four block sizes (any size, 3 and 2, 6 and 3, 7 and 3).
#define G2O_REGISTER_ALGORITHMS_(prefix, Algorithm, method, Linear, type, any, s32, s63, s73)         \
  G2O_REGISTER_OPTIMIZATION_ALGORITHM(                                                                \
      prefix##any, (internal::solver_creator<Algorithm, Linear, -1, -1>(#prefix #any, method, type))) \
  G2O_REGISTER_OPTIMIZATION_ALGORITHM(                                                                \
      prefix##s32, (internal::solver_creator<Algorithm, Linear, 3, 2>(#prefix #s32, method, type)))   \
  G2O_REGISTER_OPTIMIZATION_ALGORITHM(                                                                \
      prefix##s63, (internal::solver_creator<Algorithm, Linear, 6, 3>(#prefix #s63, method, type)))   \
  G2O_REGISTER_OPTIMIZATION_ALGORITHM(                                                                \
      prefix##s73, (internal::solver_creator<Algorithm, Linear, 7, 3>(#prefix #s73, method, type)))
#define G2O_REGISTER_GN_AND_LM(Linear, type, any, s32, s63, s73)                                          \
  G2O_REGISTER_ALGORITHMS_(gn_, OptimizationAlgorithmGaussNewton, "Gauss-Newton", Linear, type, any, s32, \
                           s63, s73)                                                                      \
  G2O_REGISTER_ALGORITHMS_(lm_, OptimizationAlgorithmLevenberg, "Levenberg-Marquardt", Linear, type, any, \
                           s32, s63, s73)
