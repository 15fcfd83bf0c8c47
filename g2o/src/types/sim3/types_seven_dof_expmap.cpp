// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/sim3/types_seven_dof_expmap.h"

#include "g2o/core/factory.h"

namespace g2o {

G2O_REGISTER_TYPE_GROUP(sim3);
G2O_USE_TYPE_GROUP(sim3_actions);

G2O_REGISTER_TYPE_NAME("VERTEX_SIM3:EXPMAP", VertexSim3Expmap);
G2O_REGISTER_TYPE_NAME("EDGE_SIM3:EXPMAP", EdgeSim3);
G2O_REGISTER_TYPE_NAME("EDGE_PROJECT_SIM3_XYZ:EXPMAP", EdgeSim3ProjectXYZ);
G2O_REGISTER_TYPE_NAME("EDGE_PROJECT_INVERSE_SIM3_XYZ:EXPMAP", EdgeInverseSim3ProjectXYZ);

}  // namespace g2o
