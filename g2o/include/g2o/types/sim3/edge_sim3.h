// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SIM3_H
#define G2O_EDGE_SIM3_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/sim3/vertex_sim3_expmap.h"

namespace g2o {

/// The measured similarity z from a camera S₁ to a camera S₂. Without noise, S₂ = z S₁. Error: log(z S₁
/// S₂⁻¹). Files store the logarithm of z⁻¹. Tag: EDGE_SIM3:EXPMAP.
class G2O_TYPES_SIM3_API EdgeSim3
    : public ReadyMadeEdge<EdgeSim3, 7, Sim3, VertexSim3Expmap, VertexSim3Expmap> {
 public:
  EdgeSim3();
  bool write(std::ostream& os) const override;
};

}  // namespace g2o

#endif  // G2O_EDGE_SIM3_H
