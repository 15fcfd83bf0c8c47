// SPDX-License-Identifier: BSD-3-Clause
// A problem of bundle adjustment as plain arrays, in the convention of BAL files (src/io/bal/bal_format.h),
// so that Ceres does not depend on types of boxplus.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace boxplus::bench {

struct __attribute__((visibility("default"))) BundleProblem {
  struct Observation {
    std::uint32_t camera, point;
    double x, y;
  };
  std::vector<std::array<double, 9>> cameras;  ///< rotation vector, translation, f, k1, k2
  std::vector<std::array<double, 3>> points;
  std::vector<Observation> observations;
};

/// Reads a BAL file. Throws std::runtime_error if it ends too early.
__attribute__((visibility("default"))) BundleProblem read_bundle_problem(const std::string& path);

/// One run of a solver. The cost is ½ Σ ‖e‖², as Ceres defines it.
struct BundleRun {
  double seconds = 0;  ///< from the call of the solver to the first iteration with a cost within the target
  double cost = 0;     ///< the lowest cost
  int iterations = 0;  ///< until the target
  /// Seconds of all iterations that were run: Jacobians and normal equations, elimination and solution of the
  /// linear system, and evaluation of the cost. Ceres does not separate elimination from solution.
  double linearize_s = 0, solve_s = 0, evaluate_s = 0;
  int iterations_run = 0;
};

}  // namespace boxplus::bench
