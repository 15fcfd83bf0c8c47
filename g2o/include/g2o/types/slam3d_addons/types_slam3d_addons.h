// SPDX-License-Identifier: BSD-3-Clause
// Planes, lines, sensor calibration, and poses in the file format of TORO.
#pragma once
#ifndef G2O_TYPES_SLAM3D_ADDONS_
#define G2O_TYPES_SLAM3D_ADDONS_

#include "g2o/types/slam3d/types_slam3d.h"
#include "g2o/types/slam3d_addons/edge_plane.h"
#include "g2o/types/slam3d_addons/edge_se3_calib.h"
#include "g2o/types/slam3d_addons/edge_se3_euler.h"
#include "g2o/types/slam3d_addons/edge_se3_line.h"
#include "g2o/types/slam3d_addons/edge_se3_plane_calib.h"
#include "g2o/types/slam3d_addons/line3d.h"
#include "g2o/types/slam3d_addons/plane3d.h"
#include "g2o/types/slam3d_addons/vertex_line3d.h"
#include "g2o/types/slam3d_addons/vertex_plane.h"
#include "g2o/types/slam3d_addons/vertex_se3_euler.h"

#endif  // G2O_TYPES_SLAM3D_ADDONS_
