// SPDX-License-Identifier: BSD-3-Clause
// Measures boxplus on simulated graphs of growing size. For each graph, a separate process loads it from a
// file, runs a few iterations, and writes the result.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "boxplus/testing/simulate.h"

namespace boxplus::bench {

/// The process prints these numbers in this order, separated by blanks.
struct ScaleFigures {
  std::uint32_t vertices = 0, edges = 0;
  double load_s = 0, plan_s = 0, write_s = 0, total_s = 0;
  double iteration_s = 0;  ///< the median time of an iteration; the first iteration is not counted
  double peak_mib = 0;
  /// The predicted times of one Cholesky factorization and of one rough solution by PCG.
  double predicted_factor_s = 0, predicted_pcg_s = 0;
  double factor_gb = 0;     ///< if `solver` is PCG, the predicted size of the Cholesky factor; otherwise 0
  std::string solver = {};  ///< the linear solver that LinearSolverKind::kAutomatic chose
};

struct ScaleResult {
  std::string world;
  int poses;
  ScaleFigures figures;
};

/// Measures street networks with 10k, 100k and 1M poses, and cubes with 10k and 100k poses, with one thread.
/// `programs` is the folder of whole_scale. Throws std::runtime_error if a run fails.
std::vector<ScaleResult> run_scale(const std::string& programs);

}  // namespace boxplus::bench
