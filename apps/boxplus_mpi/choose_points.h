// SPDX-License-Identifier: BSD-3-Clause
// Which points of a BAL problem or a COLMAP model a process reads.
#pragma once

#include <cstdint>
#include <vector>

#include "io/bal/bal_format.h"

namespace boxplus::app {

/// By the indices of points.
struct PointChoice {
  std::vector<bool> own;  ///< those of the part
  BalPoints read;         ///< these, and those that connect cameras
};

/// Chooses the points of one of `parts` parts, as parts_of_eliminated() divides them, and enough others for
/// the gauge test to find the freedom of the whole problem.
PointChoice choose_points(BalObservations observations, std::uint32_t part, int parts);

}  // namespace boxplus::app
