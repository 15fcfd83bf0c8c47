// SPDX-License-Identifier: BSD-3-Clause
// Calibration of the pose of a sensor and of the odometry of a robot in the plane.
#pragma once
#ifndef G2O_TYPES_SCLAM2D_
#define G2O_TYPES_SCLAM2D_

#include "g2o/types/sclam2d/edge_se2_odom_differential_calib.h"
#include "g2o/types/sclam2d/edge_se2_sensor_calib.h"
#include "g2o/types/sclam2d/odometry_measurement.h"
#include "g2o/types/sclam2d/vertex_odom_differential_params.h"
#include "g2o/types/slam2d/types_slam2d.h"

#endif  // G2O_TYPES_SCLAM2D_
