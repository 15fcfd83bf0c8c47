// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE3_OFFSET_H_
#define G2O_EDGE_SE3_OFFSET_H_

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam3d/parameter_se3_offset.h"
#include "g2o/types/slam3d/vertex_se3.h"

namespace g2o {

/// The measured motion z from a sensor at a pose x₁ to a sensor at a pose x₂. P₁ and P₂ are the poses of the
/// sensors on the robot. Error: the translation of z⁻¹ (x₁ P₁)⁻¹ (x₂ P₂) and the vector part of its unit
/// quaternion with w ≥ 0. Tag: EDGE_SE3_OFFSET.
class G2O_TYPES_SLAM3D_API EdgeSE3Offset
    : public ReadyMadeEdge<EdgeSE3Offset, 6, Isometry3, VertexSE3, VertexSE3> {
 public:
  EdgeSE3Offset();
  friend struct internal::EdgeModel<EdgeSE3Offset>;

 protected:
  /// Finds the caches if the object belongs to a derived class. EdgeSE3Offset itself does not use them.
  bool resolveCaches() override;

  ParameterSE3Offset* _offsetFrom = nullptr;
  ParameterSE3Offset* _offsetTo = nullptr;
  CacheSE3Offset* _cacheFrom = nullptr;  ///< set only in derived classes
  CacheSE3Offset* _cacheTo = nullptr;
};

}  // namespace g2o

#endif  // G2O_EDGE_SE3_OFFSET_H_
