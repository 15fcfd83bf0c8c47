// SPDX-License-Identifier: BSD-3-Clause
#include "parameter_se2_offset.h"

#include <istream>
#include <ostream>

namespace g2o {
namespace tutorial {

bool ParameterSE2Offset::read(std::istream& is) {
  Vector3 v;
  if (!(is >> v[0] >> v[1] >> v[2])) return false;
  _offset.fromVector(v);
  return true;
}

bool ParameterSE2Offset::write(std::ostream& os) const {
  const Vector3 v = _offset.toVector();
  os << v[0] << " " << v[1] << " " << v[2];
  return os.good();
}

// [cache]
bool CacheSE2Offset::resolveDependencies() {
  if (_parameters.size() != 1) return false;
  _offsetParam = dynamic_cast<const ParameterSE2Offset*>(_parameters[0]);
  return _offsetParam != nullptr && dynamic_cast<const VertexSE2*>(vertex()) != nullptr;
}

void CacheSE2Offset::updateImpl() {
  const auto* robot = static_cast<const VertexSE2*>(vertex());
  _sensorToWorld = robot->estimate() * _offsetParam->offset();
  _worldToSensor = _sensorToWorld.inverse();
}
// [/cache]

}  // namespace tutorial
}  // namespace g2o
