// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE3_H_
#define G2O_EDGE_SE3_H_

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam3d/vertex_se3.h"

namespace g2o {

/// The measured motion z from a pose x₁ to a pose x₂. Error: the translation of z⁻¹ x₁⁻¹ x₂ and the vector
/// part of its unit quaternion with w ≥ 0. Tag: EDGE_SE3:QUAT.
class G2O_TYPES_SLAM3D_API EdgeSE3 : public ReadyMadeEdge<EdgeSE3, 6, Isometry3, VertexSE3, VertexSE3> {
 public:
  EdgeSE3();
};

/// The action "writeGnuplot" of EdgeSE3.
class G2O_TYPES_SLAM3D_API EdgeSE3WriteGnuplotAction : public internal::NamedAction<WriteGnuplotAction> {
 public:
  EdgeSE3WriteGnuplotAction();
};

/// The action "draw" of EdgeSE3.
class G2O_TYPES_SLAM3D_API EdgeSE3DrawAction : public internal::NamedAction<DrawAction> {
 public:
  EdgeSE3DrawAction();
};

}  // namespace g2o

#endif  // G2O_EDGE_SE3_H_
