// SPDX-License-Identifier: BSD-3-Clause
// Measures simulated worlds of growing size: loads, runs a few iterations and writes, each in its own
// process.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "boxplus/testing/simulate.h"

namespace boxplus::bench {

/// The output of the measured process: these figures in this order, separated by blanks.
struct ScaleFigures {
  std::uint32_t vertices = 0, edges = 0;
  double load_s = 0, plan_s = 0, write_s = 0, total_s = 0;
  double iteration_s = 0;  ///< the median time of an iteration, without the first
  double peak_mib = 0;
  double predicted_factor_s = 0,
         predicted_pcg_s = 0;  ///< the predicted times of a factorization and a rough solution
  double factor_gb = 0;        ///< the predicted size of the factor if it was refused, and otherwise 0
  std::string solver = {};     ///< the choice of LinearSolverKind::kAutomatic
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
