// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SBA_EDGESE3EXPMAP_H
#define G2O_SBA_EDGESE3EXPMAP_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/sba/vertex_se3_expmap.h"

namespace g2o {

/// The measured motion z from a camera T₁ to a camera T₂. Without noise, T₂ = z T₁. Error: log(T₂⁻¹ z T₁).
/// Files store z⁻¹. Tag: EDGE_SE3:EXPMAP.
class G2O_TYPES_SBA_API EdgeSE3Expmap
    : public ReadyMadeEdge<EdgeSE3Expmap, 6, SE3Quat, VertexSE3Expmap, VertexSE3Expmap> {
 public:
  EdgeSE3Expmap();
};

}  // namespace g2o

#endif  // G2O_SBA_EDGESE3EXPMAP_H
