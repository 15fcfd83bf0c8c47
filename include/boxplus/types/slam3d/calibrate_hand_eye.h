// SPDX-License-Identifier: BSD-3-Clause
// The pose of a sensor on a body, computed in closed form from measured motions: the start of a calibration
// with HandEye<SE3>.
#pragma once

#include <optional>
#include <span>

#include "boxplus/types/hand_eye.h"

namespace boxplus {

/// Solves A X = X B for X in two linear least squares problems: first the rotation that turns the rotation
/// vectors of B to those of A, then the translation (Park & Martin, "Robot sensor calibration: solving AX =
/// XB on the Euclidean group", IEEE Transactions on Robotics and Automation 10(5), 1994). Needs no initial
/// guess. All motions have the same weight, and outliers have full influence. Exact if the measurements are
/// exact. Each motion must turn by less than π.
///
/// Returns nothing if the motions do not determine X, because all of them turn around the same axis or not at
/// all. Throws InvalidArgument if a number is not finite. Takes linear time.
std::optional<SE3> calibrate_hand_eye(std::span<const HandEye<SE3>> motions);

}  // namespace boxplus
