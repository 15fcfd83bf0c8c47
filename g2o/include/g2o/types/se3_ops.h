// SPDX-License-Identifier: BSD-3-Clause
// Forwards to the header of this name in slam3d/, because older clients include this path.
#pragma once

#include "g2o/types/slam3d/se3_ops.h"
