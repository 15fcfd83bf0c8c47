// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/sclam2d/types_sclam2d.h"

#include "g2o/core/factory.h"

namespace g2o {

G2O_REGISTER_TYPE_GROUP(sclam);
G2O_USE_TYPE_GROUP(sclam2d_actions);

G2O_REGISTER_TYPE(VERTEX_ODOM_DIFFERENTIAL, VertexOdomDifferentialParams);
G2O_REGISTER_TYPE(EDGE_SE2_CALIB, EdgeSE2SensorCalib);
G2O_REGISTER_TYPE(EDGE_SE2_ODOM_DIFFERENTIAL_CALIB, EdgeSE2OdomDifferentialCalib);

}  // namespace g2o
