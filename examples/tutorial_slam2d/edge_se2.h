// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "g2o/core/base_binary_edge.h"
#include "vertex_se2.h"

namespace g2o {
namespace tutorial {

// [edge]
/// The measured motion of the robot between two poses. In a file: TUTORIAL_EDGE_SE2 id1 id2 x y θ, then Ω.
class EdgeSE2 : public BaseBinaryEdge<3, SE2, VertexSE2, VertexSE2> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW

  void computeError() override {
    const auto* v1 = static_cast<const VertexSE2*>(_vertices[0]);
    const auto* v2 = static_cast<const VertexSE2*>(_vertices[1]);
    const SE2 delta = _measurement.inverse() * (v1->estimate().inverse() * v2->estimate());
    _error = delta.toVector();
  }

  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;
};
// [/edge]

}  // namespace tutorial
}  // namespace g2o
