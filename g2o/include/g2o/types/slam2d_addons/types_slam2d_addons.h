// SPDX-License-Identifier: BSD-3-Clause
// Segments and lines in the plane.
#pragma once
#ifndef G2O_TYPES_SLAM2D_ADDONS_
#define G2O_TYPES_SLAM2D_ADDONS_

#include "g2o/types/slam2d/types_slam2d.h"
#include "g2o/types/slam2d_addons/edge_line2d.h"
#include "g2o/types/slam2d_addons/edge_line2d_pointxy.h"
#include "g2o/types/slam2d_addons/edge_se2_line2d.h"
#include "g2o/types/slam2d_addons/edge_se2_segment2d.h"
#include "g2o/types/slam2d_addons/edge_se2_segment2d_line.h"
#include "g2o/types/slam2d_addons/edge_se2_segment2d_pointLine.h"
#include "g2o/types/slam2d_addons/line_2d.h"
#include "g2o/types/slam2d_addons/vertex_line2d.h"
#include "g2o/types/slam2d_addons/vertex_segment2d.h"

#endif  // G2O_TYPES_SLAM2D_ADDONS_
