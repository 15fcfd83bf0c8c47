// SPDX-License-Identifier: BSD-3-Clause
// Compares boxplus and Ceres when they read a file, optimize, and write the result. Each optimization ends
// when the relative decrease of its cost is below 1e-10.
#pragma once

#include <string>

#include "datasets/whole_run.h"

namespace boxplus::bench {

struct WholeComparison {
  WholeRun ours, ceres;
};

/// `programs` is the folder of whole_boxplus and whole_ceres. `ceres_settings` is an index into
/// all_ceres_settings(). If the first run of Ceres does not reach the chi2 `target`, Ceres is run only once.
WholeComparison run_whole_comparison(const std::string& programs, const std::string& file, int ceres_settings,
                                     double target);

}  // namespace boxplus::bench
