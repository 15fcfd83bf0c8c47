// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE2_OFFSET_H_
#define G2O_EDGE_SE2_OFFSET_H_

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam2d/parameter_se2_offset.h"
#include "g2o/types/slam2d/se2.h"
#include "g2o/types/slam2d/vertex_se2.h"

namespace g2o {

/// The measured motion z from a sensor at a pose x₁ to a sensor at a pose x₂. P₁ and P₂ are the poses of the
/// sensors on the robot. Error: (x, y, θ) of z⁻¹ (x₁ P₁)⁻¹ (x₂ P₂). Tag: EDGE_SE2_OFFSET.
class G2O_TYPES_SLAM2D_API EdgeSE2Offset : public ReadyMadeEdge<EdgeSE2Offset, 3, SE2, VertexSE2, VertexSE2> {
 public:
  EdgeSE2Offset();
  friend struct internal::EdgeModel<EdgeSE2Offset>;

 protected:
  /// Finds the caches if the object belongs to a derived class. EdgeSE2Offset itself does not use them.
  bool resolveCaches() override;

  ParameterSE2Offset* _offsetFrom = nullptr;
  ParameterSE2Offset* _offsetTo = nullptr;
  CacheSE2Offset* _cacheFrom = nullptr;  ///< set only in derived classes
  CacheSE2Offset* _cacheTo = nullptr;
};

}  // namespace g2o

#endif  // G2O_EDGE_SE2_OFFSET_H_
