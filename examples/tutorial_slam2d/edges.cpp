// SPDX-License-Identifier: BSD-3-Clause
#include <istream>
#include <ostream>

#include "edge_se2.h"
#include "edge_se2_point_xy.h"

namespace g2o {
namespace tutorial {

bool EdgeSE2::read(std::istream& is) {
  Vector3 v;
  if (!(is >> v[0] >> v[1] >> v[2])) return false;
  _measurement.fromVector(v);
  return readInformationMatrix(is);
}

bool EdgeSE2::write(std::ostream& os) const {
  const Vector3 v = _measurement.toVector();
  os << v[0] << " " << v[1] << " " << v[2] << " ";
  return writeInformationMatrix(os);
}

// [parameter]
EdgeSE2PointXY::EdgeSE2PointXY() {
  _measurement.setZero();
  resizeParameters(1);
  installParameter(_sensorOffset, 0);
}

bool EdgeSE2PointXY::resolveCaches() {
  const ParameterVector parameters = {_sensorOffset};
  resolveCache(_sensorCache, static_cast<OptimizableGraph::Vertex*>(_vertices[0]),
               "TUTORIAL_CACHE_SE2_OFFSET", parameters);
  return _sensorCache != nullptr;
}
// [/parameter]

// [jacobian]
void EdgeSE2PointXY::linearizeOplus() {
  const auto* robot = static_cast<const VertexSE2*>(_vertices[0]);
  const auto* landmark = static_cast<const VertexPointXY*>(_vertices[1]);
  const Matrix2 R_s = _sensorOffset->offset().rotation().toRotationMatrix();
  const Matrix2 R_r = robot->estimate().rotation().toRotationMatrix();
  const Vector2 q = robot->estimate().inverse() * landmark->estimate();
  _jacobianOplusXi.leftCols<2>() = -R_s.transpose();
  _jacobianOplusXi.col(2) = R_s.transpose() * Vector2(q.y(), -q.x());
  _jacobianOplusXj = R_s.transpose() * R_r.transpose();
}
// [/jacobian]

bool EdgeSE2PointXY::read(std::istream& is) {
  return readParamIds(is) && is >> _measurement[0] >> _measurement[1] && readInformationMatrix(is);
}

bool EdgeSE2PointXY::write(std::ostream& os) const {
  writeParamIds(os);
  os << _measurement[0] << " " << _measurement[1] << " ";
  return writeInformationMatrix(os);
}

}  // namespace tutorial
}  // namespace g2o
