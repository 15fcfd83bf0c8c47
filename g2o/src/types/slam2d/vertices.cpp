// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "g2o/types/slam2d/parameter_se2_offset.h"
#include "types/slam2d/adapters_slam2d.h"

namespace g2o {

VertexSE2::VertexSE2() = default;

void VertexSE2::oplusImpl(double* update) {
  const Vector2 t = _estimate.translation() + Vector2(update[0], update[1]);
  _estimate = SE2(t.x(), t.y(), normalize_theta(_estimate.rotation().angle() + update[2]));
}

bool VertexSE2::read(std::istream& is) {
  boxplus::SE2 x;
  if (!adapters::read_value(is, 3, x)) return false;
  setEstimate(adapters::to_g2o(x));
  return true;
}

bool VertexSE2::write(std::ostream& os) const {
  return adapters::write_value(os, adapters::pose(*this));
}

bool VertexSE2::getEstimateData(double* est) const {
  const Vector3 v = _estimate.toVector();
  std::copy_n(v.data(), 3, est);
  return true;
}

bool VertexSE2::setEstimateDataImpl(const double* est) {
  _estimate = SE2(est[0], est[1], est[2]);
  return true;
}

VertexPointXY::VertexPointXY() {
  _estimate.setZero();
}

void VertexPointXY::oplusImpl(double* update) {
  _estimate += Vector2(update[0], update[1]);
}

bool VertexPointXY::read(std::istream& is) {
  boxplus::Vector2 p;
  if (!adapters::read_value(is, 2, p)) return false;
  setEstimate(p);
  return true;
}

bool VertexPointXY::write(std::ostream& os) const {
  return adapters::write_value(os, adapters::point(*this));
}

bool VertexPointXY::getEstimateData(double* est) const {
  std::copy_n(_estimate.data(), 2, est);
  return true;
}

bool VertexPointXY::setEstimateDataImpl(const double* est) {
  _estimate << est[0], est[1];
  return true;
}

ParameterSE2Offset::ParameterSE2Offset() {
  setOffset();
}
ParameterSE2Offset::~ParameterSE2Offset() = default;

void ParameterSE2Offset::setOffset(const SE2& offset) {
  _offset = offset;
  _offsetMatrix = offset.toIsometry();
  _inverseOffsetMatrix = _offsetMatrix.inverse();
}

bool ParameterSE2Offset::read(std::istream& is) {
  boxplus::SE2 x;
  if (!adapters::read_value(is, 3, x)) return false;
  setOffset(adapters::to_g2o(x));
  return true;
}

bool ParameterSE2Offset::write(std::ostream& os) const {
  return adapters::write_value(os, adapters::pose(_offset));
}

CacheSE2Offset::CacheSE2Offset() = default;
CacheSE2Offset::~CacheSE2Offset() = default;

bool CacheSE2Offset::resolveDependencies() {
  _offsetParam = parameters().empty() ? nullptr : dynamic_cast<ParameterSE2Offset*>(parameters()[0]);
  return _offsetParam != nullptr && dynamic_cast<VertexSE2*>(vertex()) != nullptr;
}

void CacheSE2Offset::updateImpl() {
  const SE2& robot = static_cast<const VertexSE2*>(vertex())->estimate();
  _se2_n2w = robot * _offsetParam->offset();
  _se2_w2n = _se2_n2w.inverse();
  _n2w = _se2_n2w.toIsometry();
  _w2n = _se2_w2n.toIsometry();
  _w2l = robot.inverse().toIsometry();
}

}  // namespace g2o
