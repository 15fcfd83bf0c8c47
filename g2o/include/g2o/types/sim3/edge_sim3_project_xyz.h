// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SIM3_PROJECT_XYZ_H
#define G2O_EDGE_SIM3_PROJECT_XYZ_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/sba/types_sba.h"
#include "g2o/types/sim3/vertex_sim3_expmap.h"

namespace g2o {

/// The measured image position z (pixels) of a point p in the first camera of a vertex S. Error: z − cam1(S
/// p). Tag: EDGE_PROJECT_SIM3_XYZ:EXPMAP.
class G2O_TYPES_SIM3_API EdgeSim3ProjectXYZ
    : public ReadyMadeEdge<EdgeSim3ProjectXYZ, 2, Vector2, VertexPointXYZ, VertexSim3Expmap> {
 public:
  EdgeSim3ProjectXYZ();
};

/// The measured image position z (pixels) of a point p in the second camera of a vertex S. p is in the frame
/// of the first camera. Error: z − cam2(S⁻¹ p). Tag: EDGE_PROJECT_INVERSE_SIM3_XYZ:EXPMAP.
class G2O_TYPES_SIM3_API EdgeInverseSim3ProjectXYZ
    : public ReadyMadeEdge<EdgeInverseSim3ProjectXYZ, 2, Vector2, VertexPointXYZ, VertexSim3Expmap> {
 public:
  EdgeInverseSim3ProjectXYZ();
};

}  // namespace g2o

#endif  // G2O_EDGE_SIM3_PROJECT_XYZ_H
