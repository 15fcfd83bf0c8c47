// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE3_PRIOR_H_
#define G2O_EDGE_SE3_PRIOR_H_

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam3d/parameter_se3_offset.h"
#include "g2o/types/slam3d/vertex_se3.h"

namespace g2o {

/// A prior z for the pose of a sensor in the world. x is the pose of the robot, and P is the pose of the
/// sensor on the robot. Error: the translation of z⁻¹ x P and the vector part of its unit quaternion with w ≥
/// 0. Tag: EDGE_SE3_PRIOR.
class G2O_TYPES_SLAM3D_API EdgeSE3Prior : public ReadyMadeEdge<EdgeSE3Prior, 6, Isometry3, VertexSE3> {
 public:
  EdgeSE3Prior();

  const ParameterSE3Offset* offsetParameter() const { return offsetParam; }

 protected:
  /// Finds _cache if the object belongs to a derived class. EdgeSE3Prior itself does not use it.
  bool resolveCaches() override;

  ParameterSE3Offset* offsetParam = nullptr;
  CacheSE3Offset* _cache = nullptr;  ///< set only in derived classes
};

}  // namespace g2o

#endif  // G2O_EDGE_SE3_PRIOR_H_
