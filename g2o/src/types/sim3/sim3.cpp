// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/sim3/sim3.h"

#include "boxplus/manifold/sim3.h"

namespace g2o {

Sim3::Sim3(const Vector7& update) {
  const boxplus::Sim3 x = boxplus::Sim3::exp(update);
  const boxplus::detail::Quaternion<double> q = x.quaternion();
  r = Quaternion(q.w, q.x, q.y, q.z);
  t = x.translation();
  s = x.scale();
  normalizeRotation();
}

Vector7 Sim3::log() const {
  return boxplus::Sim3::from_unit({r.x(), r.y(), r.z(), r.w()}, t, s).log();
}

}  // namespace g2o
