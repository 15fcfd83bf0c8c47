// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <tuple>

#include "g2o/types/slam3d_addons/edge_se3_line.h"
#include "types/ready_made_edge.h"
#include "types/slam3d_addons/adapters_slam3d_addons.h"

namespace g2o {
namespace {

using NativeLine = boxplus::Manifold<boxplus::Line3>;

/// Reads w and d, which stay as they are: as in g2o, w may have a part along d, for example because it was
/// written with few digits. This part has no effect on an error or on a step.
Line3D read_line(boxplus::FieldReader& in) {
  Vector6 line;
  in.numbers(line.data(), 3, "a coordinate of the moment");
  const boxplus::FieldPlace direction = in.place();
  in.numbers(line.data() + 3, 3, "a coordinate of the direction");
  const double length = line.tail<3>().squaredNorm();
  if (!(length > 0 && std::isfinite(length)))
    in.fail(direction, "expected a direction whose length is neither zero nor huge");
  return Line3D(line);
}

}  // namespace

Line3D Line3D::fromCartesian(const Vector6& line) {
  return adapters::to_g2o(boxplus::Line3::through(line.head<3>(), line.tail<3>().normalized()));
}

Vector6 Line3D::toCartesian() const {
  Vector6 line;
  line << adapters::line(*this).nearest_point(), d().normalized();
  return line;
}

Line3D Line3D::fromOrthonormal(const OrthonormalLine3D& line) {
  Line3D result;
  result.setW(line.W(0, 0) * line.U.col(0));
  result.setD(line.W(1, 0) * line.U.col(1));
  result.normalize();
  return result;
}

OrthonormalLine3D Line3D::toOrthonormal(const Line3D& line) {
  const boxplus::detail::OrthonormalLine<double> native = boxplus::detail::orthonormal(adapters::line(line));
  OrthonormalLine3D result;
  result.U = native.U;
  result.W << native.cosine, -native.sine, native.sine, native.cosine;
  return result;
}

void Line3D::oplus(const Vector4& v) {
  *this = adapters::to_g2o(NativeLine::oplus(adapters::line(*this), v.data()));
}

Vector4 Line3D::ominus(const Line3D& line) const {
  Vector4 v;
  NativeLine::ominus(adapters::line(line), adapters::line(*this), v.data());
  return v;
}

Line3D operator*(const Isometry3& t, const Line3D& line) {
  Line3D moved;
  moved.setD(t.linear() * line.d());
  moved.setW(t.linear() * line.w() + t.translation().cross(moved.d()));
  return moved;
}

VertexLine3D::VertexLine3D() = default;

void VertexLine3D::oplusImpl(double* update) {
  _estimate.oplus(Eigen::Map<const Vector4>(update));
}

bool VertexLine3D::read(std::istream& is) {
  return adapters::read_fields(is, 6, [this](boxplus::FieldReader& in) { setEstimate(read_line(in)); });
}

bool VertexLine3D::write(std::ostream& os) const {
  return adapters::write_value(os, adapters::line(*this));
}

bool VertexLine3D::getEstimateData(double* est) const {
  std::copy_n(_estimate.data(), 6, est);
  return true;
}

bool VertexLine3D::setEstimateDataImpl(const double* est) {
  _estimate = Line3D(Vector6(est));
  return true;
}

namespace internal {

template <>
struct EdgeModel<EdgeSE3Line3D> {
  using Native = boxplus::LineObservation3;
  static auto parameters(const EdgeSE3Line3D& e) { return std::tuple(adapters::pose(*e.offsetParameter())); }
  static Line3D from_file(boxplus::FieldReader& in) { return read_line(in); }
  static Line3D measured(const EdgeSE3Line3D& e) {
    const Isometry3 sensor = estimate<0>(e) * e.offsetParameter()->offset();
    return sensor.inverse() * estimate<1>(e);
  }
  static Line3D second(const EdgeSE3Line3D& e) {
    return estimate<0>(e) * e.offsetParameter()->offset() * e.measurement();
  }
};

template struct EdgeFunctions<EdgeSE3Line3D>;

}  // namespace internal

EdgeSE3Line3D::EdgeSE3Line3D() {
  resizeParameters(1);
  installParameter(offsetParam, 0);
}

}  // namespace g2o
