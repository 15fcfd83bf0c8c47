// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SBA_EDGESBASCALE_H
#define G2O_SBA_EDGESBASCALE_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/sba/vertex_cam.h"

namespace g2o {

/// The measured distance z between two cameras. Error: z − |t₂ − t₁|, with the positions t₁ and t₂ of the
/// cameras. Tag: EDGE_SCALE.
/// initialEstimate() moves a camera along the line through both, so that their distance becomes z.
class G2O_TYPES_SBA_API EdgeSBAScale : public ReadyMadeEdge<EdgeSBAScale, 1, double, VertexCam, VertexCam> {
 public:
  EdgeSBAScale();
};

}  // namespace g2o

#endif  // G2O_SBA_EDGESBASCALE_H
