// SPDX-License-Identifier: BSD-3-Clause
#include <istream>
#include <ostream>

#include "vertex_point_xy.h"
#include "vertex_se2.h"

namespace g2o {
namespace tutorial {

// [files]
bool VertexSE2::read(std::istream& is) {
  Vector3 v;
  if (!(is >> v[0] >> v[1] >> v[2])) return false;
  _estimate.fromVector(v);
  return true;
}

bool VertexSE2::write(std::ostream& os) const {
  const Vector3 v = _estimate.toVector();
  os << v[0] << " " << v[1] << " " << v[2];
  return os.good();
}
// [/files]

bool VertexPointXY::read(std::istream& is) {
  return static_cast<bool>(is >> _estimate[0] >> _estimate[1]);
}

bool VertexPointXY::write(std::ostream& os) const {
  os << _estimate[0] << " " << _estimate[1];
  return os.good();
}

}  // namespace tutorial
}  // namespace g2o
