// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SBA_EDGESBACAM_H
#define G2O_SBA_EDGESBACAM_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/sba/vertex_cam.h"

namespace g2o {

/// The measured motion z from a camera c₁ to a camera c₂. Error: the translation of z⁻¹ c₁⁻¹ c₂ and the
/// vector part of its unit quaternion with w ≥ 0. Tag: EDGE_CAM.
/// initialEstimate() does not change the camera matrix.
class G2O_TYPES_SBA_API EdgeSBACam : public ReadyMadeEdge<EdgeSBACam, 6, SE3Quat, VertexCam, VertexCam> {
 public:
  EdgeSBACam();
};

}  // namespace g2o

#endif  // G2O_SBA_EDGESBACAM_H
