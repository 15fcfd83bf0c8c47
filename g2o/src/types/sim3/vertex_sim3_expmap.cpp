// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/sim3/vertex_sim3_expmap.h"

#include "g2o/core/factory.h"
#include "g2o/core/refused_step.h"
#include "types/adapters.h"
#include "types/sim3/usable_sim3.h"

G2O_USE_TYPE_GROUP(sim3)  // registers the tags for clients that use only these types

namespace g2o {

VertexSim3Expmap::VertexSim3Expmap() = default;

void VertexSim3Expmap::oplusImpl(double* update) {
  Vector7 step = Eigen::Map<const Vector7>(update);
  if (_fix_scale) step[6] = 0;
  const Sim3 moved = Sim3(step) * _estimate;
  if (!adapters::is_usable(moved)) return internal::refuseStep(*this);
  _estimate = moved;
}

// In files that g2o writes, the line ends after the first camera. The second camera then keeps its values.
bool VertexSim3Expmap::read(std::istream& is) {
  boxplus::Vector<double, 11> v;
  if (!adapters::read_value(is, 11, v)) return false;
  const Sim3 camera_world(Vector7(v.head<7>()));
  if (!adapters::is_usable(camera_world)) {
    internal::complain(is, adapters::kExpectedUsableSim3);
    return false;
  }
  Vector2 focal_length = _focal_length2, principle_point = _principle_point2;
  if (!adapters::read_rest(is,
                           {&focal_length[0], &focal_length[1], &principle_point[0], &principle_point[1]}))
    return false;
  _focal_length1 = v.segment<2>(7);
  _principle_point1 = v.segment<2>(9);
  _focal_length2 = focal_length;
  _principle_point2 = principle_point;
  setEstimate(camera_world.inverse());
  return true;
}

bool VertexSim3Expmap::write(std::ostream& os) const {
  if (!adapters::is_usable(_estimate)) return false;
  boxplus::Vector<double, 11> v;
  v << _estimate.inverse().log(), _focal_length1, _principle_point1;
  return adapters::write_value(os, v) &&
         adapters::write_rest(
             os, {_focal_length2[0], _focal_length2[1], _principle_point2[0], _principle_point2[1]});
}

}  // namespace g2o
