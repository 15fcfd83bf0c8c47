// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_XYZ_PRIOR_H_
#define G2O_EDGE_XYZ_PRIOR_H_

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam3d/vertex_pointxyz.h"

namespace g2o {

/// A prior z for a point p. Error: p − z. Tag: EDGE_POINTXYZ_PRIOR.
class G2O_TYPES_SLAM3D_API EdgeXYZPrior : public ReadyMadeEdge<EdgeXYZPrior, 3, Vector3, VertexPointXYZ> {
 public:
  EdgeXYZPrior();
};

}  // namespace g2o

#endif  // G2O_EDGE_XYZ_PRIOR_H_
