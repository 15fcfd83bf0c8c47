// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam3d/parameter_camera.h"

#include "types/slam3d/adapters_slam3d.h"
#include "types/slam3d/cameras.h"

namespace g2o {

ParameterCamera::ParameterCamera() {
  setOffset();
}

void ParameterCamera::setKcam(double fx, double fy, double cx, double cy) {
  _Kcam = adapters::camera_matrix(fx, fy, cx, cy);
  _invKcam = _Kcam.inverse();
  _Kcam_inverseOffsetR = _Kcam * inverseOffset().linear();
}

void ParameterCamera::setOffset(const Isometry3& offset) {
  ParameterSE3Offset::setOffset(offset);
  _Kcam_inverseOffsetR = _Kcam * inverseOffset().linear();
}

bool ParameterCamera::read(std::istream& is) {
  boxplus::Vector<double, 4> v;
  if (!ParameterSE3Offset::read(is) || !adapters::read_value(is, 4, v)) return false;
  setKcam(v[0], v[1], v[2], v[3]);
  return true;
}

bool ParameterCamera::write(std::ostream& os) const {
  return ParameterSE3Offset::write(os) &&
         adapters::write_rest(os, {_Kcam(0, 0), _Kcam(1, 1), _Kcam(0, 2), _Kcam(1, 2)});
}

CacheCamera::CacheCamera() = default;

bool CacheCamera::resolveDependencies() {
  if (!CacheSE3Offset::resolveDependencies()) return false;
  params = dynamic_cast<ParameterCamera*>(parameters()[0]);
  return params != nullptr;
}

void CacheCamera::updateImpl() {
  CacheSE3Offset::updateImpl();
  _w2i.matrix().topRows<3>() = params->Kcam() * w2n().matrix().topRows<3>();
}

}  // namespace g2o
