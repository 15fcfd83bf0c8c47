// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "types/slam3d/adapters_slam3d.h"

namespace g2o {
namespace internal {

void RotationMemory::set(const Coefficients& q, Eigen::Ref<Matrix3, 0, Eigen::OuterStride<>> R) {
  quaternion_ = q;
  R = boxplus::detail::rotation_matrix(
      boxplus::detail::normalized(boxplus::detail::Quaternion<double>{q[0], q[1], q[2], q[3]}));
  rotation_ = R;
}

void RotationMemory::keep(const Isometry3& pose) {
  quaternion_ = get(pose);
  rotation_ = pose.linear();
}

RotationMemory::Coefficients RotationMemory::get(const Isometry3& pose) const {
  if (rotation_ == pose.linear()) return quaternion_;
  const boxplus::detail::Quaternion<double> q = boxplus::detail::normalized(
      boxplus::detail::quaternion_of(boxplus::Matrix<double, 3, 3>(pose.linear())));
  return {q.x, q.y, q.z, q.w};
}

}  // namespace internal

VertexSE3::VertexSE3() {
  _estimate.setIdentity();
}

void VertexSE3::oplusImpl(double* update) {
  const boxplus::SE3 moved = boxplus::Manifold<boxplus::SE3>::oplus(adapters::pose(*this), update);
  _estimate.translation() = moved.translation();
  rotation_.set(adapters::quaternion(moved), _estimate.linear());
}

void VertexSE3::push() {
  BaseVertex<6, Isometry3>::push();
  rotation_backup_.push_back(rotation_);
}

void VertexSE3::pop() {
  if (rotation_backup_.empty()) return;
  rotation_ = rotation_backup_.back();
  rotation_backup_.pop_back();
  BaseVertex<6, Isometry3>::pop();
}

void VertexSE3::discardTop() {
  BaseVertex<6, Isometry3>::discardTop();
  if (!rotation_backup_.empty()) rotation_backup_.pop_back();
}

bool VertexSE3::read(std::istream& is) {
  boxplus::SE3 x;
  if (!adapters::read_value(is, 7, x)) return false;
  _estimate.translation() = x.translation();
  rotation_.set(adapters::quaternion(x), _estimate.linear());
  updateCache();
  return true;
}

bool VertexSE3::write(std::ostream& os) const {
  return adapters::write_value(os, adapters::pose(*this));
}

bool VertexSE3::getEstimateData(double* est) const {
  std::copy_n(adapters::pose(*this).data(), 7, est);
  return true;
}

bool VertexSE3::getMinimalEstimateData(double* est) const {
  const Vector6 v = adapters::pose(*this).minimal();
  std::copy_n(v.data(), 6, est);
  return true;
}

bool VertexSE3::setEstimateDataImpl(const double* est) {
  _estimate = internal::fromVectorQT(Eigen::Map<const Vector7>(est));
  return true;
}

bool VertexSE3::setMinimalEstimateDataImpl(const double* est) {
  _estimate = internal::fromVectorMQT(Eigen::Map<const Vector6>(est));
  return true;
}

VertexPointXYZ::VertexPointXYZ() {
  _estimate.setZero();
}

void VertexPointXYZ::oplusImpl(double* update) {
  _estimate += Vector3(update[0], update[1], update[2]);
}

bool VertexPointXYZ::read(std::istream& is) {
  boxplus::Vector3 p;
  if (!adapters::read_value(is, 3, p)) return false;
  setEstimate(p);
  return true;
}

bool VertexPointXYZ::write(std::ostream& os) const {
  return adapters::write_value(os, adapters::point(*this));
}

bool VertexPointXYZ::getEstimateData(double* est) const {
  std::copy_n(_estimate.data(), 3, est);
  return true;
}

bool VertexPointXYZ::setEstimateDataImpl(const double* est) {
  _estimate << est[0], est[1], est[2];
  return true;
}

ParameterSE3Offset::ParameterSE3Offset() {
  setOffset();
}
ParameterSE3Offset::~ParameterSE3Offset() = default;

void ParameterSE3Offset::setOffset(const Isometry3& offset) {
  _offset = offset;
  _inverseOffset = offset.inverse();
  rotation_.keep(offset);
}

bool ParameterSE3Offset::read(std::istream& is) {
  boxplus::SE3 x;
  if (!adapters::read_value(is, 7, x)) return false;
  Isometry3 offset = adapters::to_g2o(x);
  rotation_.set(adapters::quaternion(x), offset.linear());
  setOffset(offset);
  return true;
}

bool ParameterSE3Offset::write(std::ostream& os) const {
  return adapters::write_value(os, adapters::pose(*this));
}

CacheSE3Offset::CacheSE3Offset() = default;
CacheSE3Offset::~CacheSE3Offset() = default;

bool CacheSE3Offset::resolveDependencies() {
  _offsetParam = parameters().empty() ? nullptr : dynamic_cast<ParameterSE3Offset*>(parameters()[0]);
  return _offsetParam != nullptr && dynamic_cast<VertexSE3*>(vertex()) != nullptr;
}

void CacheSE3Offset::updateImpl() {
  const Isometry3& robot = static_cast<const VertexSE3*>(vertex())->estimate();
  _n2w = robot * _offsetParam->offset();
  _w2n = _n2w.inverse();
  _w2l = robot.inverse();
}

}  // namespace g2o
