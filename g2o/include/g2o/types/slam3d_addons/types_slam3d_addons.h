// SPDX-License-Identifier: BSD-3-Clause
// Planes, and the calibration of sensors on a robot.
#pragma once

#include "g2o/types/slam3d/types_slam3d.h"
#include "g2o/types/slam3d_addons/edge_plane.h"
#include "g2o/types/slam3d_addons/edge_se3_calib.h"
#include "g2o/types/slam3d_addons/edge_se3_plane_calib.h"
#include "g2o/types/slam3d_addons/plane3d.h"
#include "g2o/types/slam3d_addons/vertex_plane.h"
