// SPDX-License-Identifier: BSD-3-Clause
// Simulated worlds of growing size: load, a few iterations, write, in a process each.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "boxplus/testing/simulate.h"

namespace boxplus::bench {

/// What the measured process prints, in this order, with blanks between.
struct ScaleFigures {
  std::uint32_t vertices = 0, edges = 0;
  double load_s = 0, plan_s = 0, write_s = 0, total_s = 0;
  double iteration_s = 0;  ///< median, the first left out
  double peak_mib = 0;
  double predicted_factor_s = 0, predicted_pcg_s = 0;  ///< per factorisation, per rough solution
  double factor_gb = 0;                                ///< predicted, where it was refused
  std::string solver = {};                             ///< that LinearSolverKind::kAutomatic chose
};

struct ScaleResult {
  std::string world;
  int poses;
  ScaleFigures figures;
};

/// Street networks of 10k, 100k and 1M poses, and cubes of 10k and 100k; one thread. `programs` holds
/// whole_scale. Throws std::runtime_error where one fails.
std::vector<ScaleResult> run_scale(const std::string& programs);

}  // namespace boxplus::bench
