// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "g2o/core/base_binary_edge.h"
#include "parameter_se2_offset.h"
#include "vertex_point_xy.h"

namespace g2o {
namespace tutorial {

// [edge]
/// The measured position of a landmark in the frame of the sensor. In a file: TUTORIAL_EDGE_SE2_POINT_XY id1
/// id2 parameter x y, then Ω.
class EdgeSE2PointXY : public BaseBinaryEdge<2, Vector2, VertexSE2, VertexPointXY> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgeSE2PointXY();

  void computeError() override {
    const auto* landmark = static_cast<const VertexPointXY*>(_vertices[1]);
    _error = _sensorCache->worldToSensor() * landmark->estimate() - _measurement;
  }
  void linearizeOplus() override;

  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

 protected:
  bool resolveCaches() override;

  ParameterSE2Offset* _sensorOffset = nullptr;
  CacheSE2Offset* _sensorCache = nullptr;
};
// [/edge]

}  // namespace tutorial
}  // namespace g2o
