// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "g2o/core/base_vertex.h"
#include "se2.h"

namespace g2o {
namespace tutorial {

// [vertex]
/// A pose of the robot. In a file: TUTORIAL_VERTEX_SE2 id x y θ
class VertexSE2 : public BaseVertex<3, SE2> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW

  void setToOriginImpl() override { _estimate = SE2(); }

  void oplusImpl(const double* update) override {
    const SE2 step(update[0], update[1], update[2]);
    _estimate = _estimate * step;
  }

  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;
};
// [/vertex]

}  // namespace tutorial
}  // namespace g2o
