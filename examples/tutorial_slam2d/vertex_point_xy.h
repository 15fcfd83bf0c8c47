// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "g2o/core/base_vertex.h"

namespace g2o {
namespace tutorial {

// [vertex]
/// The position of a landmark. In a file: TUTORIAL_VERTEX_POINT_XY id x y
class VertexPointXY : public BaseVertex<2, Vector2> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  VertexPointXY() { _estimate.setZero(); }

  void setToOriginImpl() override { _estimate.setZero(); }

  void oplusImpl(const double* update) override {
    _estimate[0] += update[0];
    _estimate[1] += update[1];
  }

  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;
};
// [/vertex]

}  // namespace tutorial
}  // namespace g2o
