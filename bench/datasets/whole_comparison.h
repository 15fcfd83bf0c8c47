// SPDX-License-Identifier: BSD-3-Clause
// From file to file: boxplus and Ceres, each until its own tolerance of 1e-10 ends it.
#pragma once

#include <string>

#include "datasets/whole_run.h"

namespace boxplus::bench {

struct WholeComparison {
  WholeRun ours, ceres;
};

/// `programs` is the folder of whole_boxplus and whole_ceres. A run of Ceres that misses `target` is not
/// repeated.
WholeComparison run_whole_comparison(const std::string& programs, const std::string& file, int ceres_settings,
                                     double target);

}  // namespace boxplus::bench
