// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/registry.h"
#include "boxplus/types/slam3d.h"

namespace boxplus {

void register_slam3d(Registry& registry) {
  registry.vertex<SE3>("VERTEX_SE3:QUAT");
  registry.vertex<Vector3>("VERTEX_TRACKXYZ");
  registry.old_vertex<Vector3>("VERTEX_XYZ");
  registry.parameter<SE3>("PARAMS_SE3OFFSET");
  registry.edge<Between<SE3>, SE3, SE3>("EDGE_SE3:QUAT");
  registry.edge<OffsetPointObservation3, SE3, Vector3, Parameter<SE3>>("EDGE_SE3_TRACKXYZ");
  registry.edge<OffsetPrior<SE3>, SE3, Parameter<SE3>>("EDGE_SE3_PRIOR");
  registry.edge<PositionPrior<Vector3>, SE3, Parameter<SE3>>("EDGE_SE3_XYZ_PRIOR");
  registry.edge<OffsetBetween<SE3>, SE3, SE3, Parameter<SE3>, Parameter<SE3>>("EDGE_SE3_OFFSET");
  registry.edge_with_shared_parameter<OffsetBetween<SE3>, SE3, SE3, Parameter<SE3>>("EDGE_SE3_OFFSET");
  registry.edge<Between<Vector3>, Vector3, Vector3>("EDGE_POINTXYZ");
  registry.edge<Prior<Vector3>, Vector3>("EDGE_POINTXYZ_PRIOR");
  registry.edge<PointsObservation3, SE3, Tail<Vector3>>("EDGE_SE3_LOTSOF_XYZ");
}

}  // namespace boxplus
