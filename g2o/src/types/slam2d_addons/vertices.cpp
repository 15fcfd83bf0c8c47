// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>

#include "types/slam2d_addons/adapters_slam2d_addons.h"

namespace g2o {
namespace {

int point_id(std::int64_t id) {
  if (id < -1 || id > std::numeric_limits<int>::max())
    throw boxplus::Error("expected -1 or the id of a point, got " + std::to_string(id));
  return static_cast<int>(id);
}

}  // namespace

VertexSegment2D::VertexSegment2D() {
  _estimate.setZero();
}

void VertexSegment2D::oplusImpl(double* update) {
  _estimate += Eigen::Map<const Vector4>(update);
}

bool VertexSegment2D::read(std::istream& is) {
  boxplus::Segment2 s;
  if (!adapters::read_value(is, 4, s)) return false;
  setEstimateP1(s.first);
  setEstimateP2(s.second);
  return true;
}

bool VertexSegment2D::write(std::ostream& os) const {
  return adapters::write_value(os, adapters::segment(*this));
}

bool VertexSegment2D::getEstimateData(double* est) const {
  std::copy_n(_estimate.data(), 4, est);
  return true;
}

bool VertexSegment2D::setEstimateDataImpl(const double* est) {
  _estimate = Eigen::Map<const Vector4>(est);
  return true;
}

VertexLine2D::VertexLine2D() = default;

void VertexLine2D::oplusImpl(double* update) {
  setTheta(normalize_theta(theta() + update[0]));
  setRho(rho() + update[1]);
}

bool VertexLine2D::read(std::istream& is) {
  return adapters::read_fields(is, 4, [this](boxplus::FieldReader& in) {
    const auto line = boxplus::FileFields<boxplus::Line2>::read(in);
    p1Id = point_id(line.ends[0]);
    p2Id = point_id(line.ends[1]);
    setEstimate(Vector2(line.angle, line.distance));
  });
}

bool VertexLine2D::write(std::ostream& os) const {
  return adapters::write_value(os, adapters::line(*this));
}

bool VertexLine2D::getEstimateData(double* est) const {
  std::copy_n(_estimate.data(), 2, est);
  return true;
}

bool VertexLine2D::setEstimateDataImpl(const double* est) {
  _estimate = Vector2(est[0], est[1]);
  return true;
}

}  // namespace g2o
