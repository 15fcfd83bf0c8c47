// SPDX-License-Identifier: BSD-3-Clause
// The results of `boxplus compare`, as text and as JSON.
#pragma once

#include <string>

#include "trajectory/trajectory_errors.h"

namespace boxplus::app {

struct Comparison {
  std::string result, truth;  ///< the names of the files
  std::size_t result_poses = 0, truth_poses = 0, matched = 0;
  std::string matched_by;  ///< PosePairs::matched_by
  AlignmentKind kind = AlignmentKind::kRigid;
  Alignment alignment;
  RelativeSpan span;
  ErrorStatistics absolute;
  double scaled_rmse = -1;  ///< of the ATE with --scale, if it is much lower; otherwise negative
  RelativeError relative;
};

std::string comparison_text(const Comparison& comparison);
std::string comparison_json(const Comparison& comparison);

}  // namespace boxplus::app
