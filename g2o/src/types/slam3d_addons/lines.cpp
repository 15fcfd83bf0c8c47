// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "g2o/types/slam3d_addons/edge_se3_line.h"
#include "types/slam3d_addons/adapters_slam3d_addons.h"

namespace g2o {
namespace {

using Observation = boxplus::LineObservation3;
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

EdgeSE3Line3D::EdgeSE3Line3D() {
  resizeParameters(1);
  installParameter(offsetParam, 0);
}

void EdgeSE3Line3D::computeError() {
  _error = Observation(adapters::line(_measurement))
               .error(adapters::pose(*vertexXn<0>()), adapters::line(*vertexXn<1>()),
                      adapters::pose(*offsetParam));
}

void EdgeSE3Line3D::linearizeOplus() {
  adapters::linearize(
      Observation(adapters::line(_measurement)),
      adapters::Argument<boxplus::SE3>{adapters::pose(*vertexXn<0>()), _jacobianOplusXi.data()},
      adapters::Argument<boxplus::Line3>{adapters::line(*vertexXn<1>()), _jacobianOplusXj.data()},
      adapters::Argument<boxplus::SE3>{adapters::pose(*offsetParam), nullptr});
}

bool EdgeSE3Line3D::read(std::istream& is) {
  const int fields = 6 + adapters::omega_fields(_information);
  return readParamIds(is) && adapters::read_fields(is, fields, [this](boxplus::FieldReader& in) {
           const Line3D line = read_line(in);
           adapters::read_omega(in, _information);
           setMeasurement(line);
         });
}

bool EdgeSE3Line3D::write(std::ostream& os) const {
  return writeParamIds(os) &&
         adapters::write_edge(os, Observation(adapters::line(_measurement)), _information);
}

bool EdgeSE3Line3D::setMeasurementData(const double* d) {
  setMeasurement(Line3D(Vector6(d)));
  return true;
}

bool EdgeSE3Line3D::getMeasurementData(double* d) const {
  std::copy_n(_measurement.data(), 6, d);
  return true;
}

bool EdgeSE3Line3D::setMeasurementFromState() {
  const Isometry3 sensor = vertexXn<0>()->estimate() * offsetParam->offset();
  setMeasurement(sensor.inverse() * vertexXn<1>()->estimate());
  return true;
}

double EdgeSE3Line3D::initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                              OptimizableGraph::Vertex* to) {
  return from.count(_vertices[0]) > 0 && to == vertexXn<1>() ? 1. : -1.;
}

void EdgeSE3Line3D::initialEstimate(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  vertexXn<1>()->setEstimate(vertexXn<0>()->estimate() * offsetParam->offset() * _measurement);
}

}  // namespace g2o
