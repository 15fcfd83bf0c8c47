// SPDX-License-Identifier: BSD-3-Clause
// Solves a BundleProblem by Ceres. This code is a separate library; datasets/ceres/ceres_peer.h says why.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "bundle/bundle_problem.h"

namespace boxplus::bench {

/// One configuration of Ceres.
struct CeresBundleSettings {
  enum class Solver : std::uint8_t { kDenseSchur, kSparseSchur, kIterativeSchur };
  std::string_view name;
  Solver solver = Solver::kDenseSchur;
  bool analytic = false;  ///< Jacobians by hand instead of automatic differentiation
};

class __attribute__((visibility("default"))) CeresBundle {
 public:
  CeresBundle(const BundleProblem& problem, bool analytic);
  ~CeresBundle();
  /// Solves the problem from its start. The run ends when the cost is at most `target`.
  BundleRun run(CeresBundleSettings::Solver solver, int threads, double target);

 private:
  struct Model;
  std::unique_ptr<Model> model_;
};

}  // namespace boxplus::bench
