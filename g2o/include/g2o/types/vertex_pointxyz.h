// SPDX-License-Identifier: BSD-3-Clause
// Forwards to slam3d/vertex_pointxyz.h, because older clients include this path.
#pragma once

#include "g2o/types/slam3d/vertex_pointxyz.h"
