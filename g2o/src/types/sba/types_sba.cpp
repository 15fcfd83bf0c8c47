// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/sba/types_sba.h"

#include "g2o/core/factory.h"

namespace g2o {

G2O_REGISTER_TYPE_GROUP(sba);
G2O_USE_TYPE_GROUP(sba_actions);

G2O_REGISTER_TYPE(VERTEX_CAM, VertexCam);
G2O_REGISTER_TYPE(VERTEX_XYZ, VertexSBAPointXYZ);
G2O_REGISTER_TYPE(VERTEX_INTRINSICS, VertexIntrinsics);
G2O_REGISTER_TYPE(EDGE_PROJECT_P2MC, EdgeProjectP2MC);
G2O_REGISTER_TYPE(EDGE_PROJECT_P2SC, EdgeProjectP2SC);
G2O_REGISTER_TYPE(EDGE_CAM, EdgeSBACam);
G2O_REGISTER_TYPE(EDGE_SCALE, EdgeSBAScale);

}  // namespace g2o
