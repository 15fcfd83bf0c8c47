// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/sim3/vertex_sim3_expmap.h"

#include "g2o/core/factory.h"
#include "types/native.h"

G2O_USE_TYPE_GROUP(sim3)  // for whoever uses these types alone

namespace g2o {

VertexSim3Expmap::VertexSim3Expmap() = default;

void VertexSim3Expmap::oplusImpl(double* update) {
  Vector7 step = Eigen::Map<const Vector7>(update);
  if (_fix_scale) step[6] = 0;
  _estimate = Sim3(step) * _estimate;
}

// Files of g2o end after the first camera.
bool VertexSim3Expmap::read(std::istream& is) {
  boxplus::Vector<double, 11> v;
  if (!native::read_value(is, 11, v)) return false;
  Vector2 focal_length = _focal_length2, principle_point = _principle_point2;
  if (!native::read_rest(is, {&focal_length[0], &focal_length[1], &principle_point[0], &principle_point[1]}))
    return false;
  _focal_length1 = v.segment<2>(7);
  _principle_point1 = v.segment<2>(9);
  _focal_length2 = focal_length;
  _principle_point2 = principle_point;
  setEstimate(Sim3(Vector7(v.head<7>())).inverse());
  return true;
}

bool VertexSim3Expmap::write(std::ostream& os) const {
  boxplus::Vector<double, 11> v;
  v << _estimate.inverse().log(), _focal_length1, _principle_point1;
  return native::write_value(os, v) && native::write_rest(os, {_focal_length2[0], _focal_length2[1],
                                                               _principle_point2[0], _principle_point2[1]});
}

}  // namespace g2o
