// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE3_PRIOR_XYZ_H
#define G2O_EDGE_SE3_PRIOR_XYZ_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam3d/parameter_se3_offset.h"
#include "g2o/types/slam3d/vertex_se3.h"

namespace g2o {

/// A prior z for the position of a pose x. Error: t − z, with the translation t of x. In files, the edge has
/// the id of an offset parameter, but the error does not use the parameter. Tag: EDGE_SE3_XYZ_PRIOR.
class G2O_TYPES_SLAM3D_API EdgeSE3XYZPrior : public ReadyMadeEdge<EdgeSE3XYZPrior, 3, Vector3, VertexSE3> {
 public:
  EdgeSE3XYZPrior();

  const ParameterSE3Offset* offsetParameter() const { return offsetParam; }

 protected:
  /// Finds _cache if the object belongs to a derived class. EdgeSE3XYZPrior itself does not use it.
  bool resolveCaches() override;

  ParameterSE3Offset* offsetParam = nullptr;
  CacheSE3Offset* _cache = nullptr;  ///< set only in derived classes
};

}  // namespace g2o

#endif  // G2O_EDGE_SE3_PRIOR_XYZ_H
