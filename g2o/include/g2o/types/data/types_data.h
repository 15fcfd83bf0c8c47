// SPDX-License-Identifier: BSD-3-Clause
// Data that is attached to vertices: laser scans, names and ellipses.
#pragma once
#ifndef G2O_TYPES_DATA_H
#define G2O_TYPES_DATA_H

#include "g2o/types/data/data_queue.h"
#include "g2o/types/data/laser_parameters.h"
#include "g2o/types/data/raw_laser.h"
#include "g2o/types/data/robot_data.h"
#include "g2o/types/data/robot_laser.h"
#include "g2o/types/data/vertex_ellipse.h"
#include "g2o/types/data/vertex_tag.h"

#endif  // G2O_TYPES_DATA_H
