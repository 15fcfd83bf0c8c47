// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "g2o/types/slam2d_addons/edge_se2_segment2d.h"
#include "g2o/types/slam2d_addons/edge_se2_segment2d_line.h"
#include "g2o/types/slam2d_addons/edge_se2_segment2d_pointLine.h"
#include "types/slam2d_addons/adapters_slam2d_addons.h"

namespace g2o {
namespace {

using Ends = boxplus::SegmentObservation2;
using Line = boxplus::SegmentLineObservation2;
using End = boxplus::SegmentEndObservation2;

/// The error of an edge between a pose and a segment.
template <class Native, class Edge>
auto error_of(const Native& native, const Edge& e) {
  return native.error(adapters::pose(*e.template vertexXn<0>()),
                      adapters::segment(*e.template vertexXn<1>()));
}

template <class Native, class Edge>
void linearize(const Native& native, const Edge& e, double* from_pose, double* from_segment) {
  adapters::linearize(
      native, adapters::Argument<boxplus::SE2>{adapters::pose(*e.template vertexXn<0>()), from_pose},
      adapters::Argument<boxplus::Segment2>{adapters::segment(*e.template vertexXn<1>()), from_segment});
}

}  // namespace

EdgeSE2Segment2D::EdgeSE2Segment2D() {
  _measurement.setZero();
}

void EdgeSE2Segment2D::computeError() {
  _error = error_of(Ends(_measurement), *this);
}

void EdgeSE2Segment2D::linearizeOplus() {
  linearize(Ends(_measurement), *this, _jacobianOplusXi.data(), _jacobianOplusXj.data());
}

bool EdgeSE2Segment2D::read(std::istream& is) {
  return adapters::read_edge<Ends>(is, 4, _information, [this](const auto& z) { setMeasurement(z); });
}

bool EdgeSE2Segment2D::write(std::ostream& os) const {
  return adapters::write_edge(os, Ends(_measurement), _information);
}

bool EdgeSE2Segment2D::setMeasurementData(const double* d) {
  setMeasurement(Vector4(d));
  return true;
}

bool EdgeSE2Segment2D::getMeasurementData(double* d) const {
  std::copy_n(_measurement.data(), 4, d);
  return true;
}

bool EdgeSE2Segment2D::setMeasurementFromState() {
  setMeasurement(error_of(Ends(Vector4::Zero()), *this));  // the error of z = 0 is what z measures
  return true;
}

double EdgeSE2Segment2D::initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                                 OptimizableGraph::Vertex* to) {
  return from.count(_vertices[0]) > 0 && to == vertexXn<1>() ? 1. : -1.;
}

void EdgeSE2Segment2D::initialEstimate(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  const SE2& pose = vertexXn<0>()->estimate();
  vertexXn<1>()->setEstimateP1(pose * measurementP1());
  vertexXn<1>()->setEstimateP2(pose * measurementP2());
}

EdgeSE2Segment2DLine::EdgeSE2Segment2DLine() {
  _measurement.setZero();
}

void EdgeSE2Segment2DLine::computeError() {
  _error = error_of(Line(_measurement), *this);
}

void EdgeSE2Segment2DLine::linearizeOplus() {
  linearize(Line(_measurement), *this, _jacobianOplusXi.data(), _jacobianOplusXj.data());
}

bool EdgeSE2Segment2DLine::read(std::istream& is) {
  return adapters::read_edge<Line>(is, 2, _information, [this](const auto& z) { setMeasurement(z); });
}

bool EdgeSE2Segment2DLine::write(std::ostream& os) const {
  return adapters::write_edge(os, Line(_measurement), _information);
}

bool EdgeSE2Segment2DLine::setMeasurementData(const double* d) {
  setMeasurement(Vector2(d));
  return true;
}

bool EdgeSE2Segment2DLine::getMeasurementData(double* d) const {
  std::copy_n(_measurement.data(), 2, d);
  return true;
}

bool EdgeSE2Segment2DLine::setMeasurementFromState() {
  setMeasurement(error_of(Line(Vector2::Zero()), *this));
  return true;
}

EdgeSE2Segment2DPointLine::EdgeSE2Segment2DPointLine() {
  _measurement.setZero();
}

void EdgeSE2Segment2DPointLine::computeError() {
  _error = error_of(End(_measurement, _pointNum != 0), *this);
}

void EdgeSE2Segment2DPointLine::linearizeOplus() {
  linearize(End(_measurement, _pointNum != 0), *this, _jacobianOplusXi.data(), _jacobianOplusXj.data());
}

bool EdgeSE2Segment2DPointLine::read(std::istream& is) {
  return adapters::read_fields(is, 4 + adapters::omega_fields(_information),
                               [this](boxplus::FieldReader& in) {
                                 const End edge = boxplus::EdgeFields<End>::read(in);
                                 adapters::read_omega(in, _information);
                                 setMeasurement(edge.measurement);
                                 setPointNum(edge.is_second ? 1 : 0);
                               });
}

bool EdgeSE2Segment2DPointLine::write(std::ostream& os) const {
  return adapters::write_edge(os, End(_measurement, _pointNum != 0), _information);
}

bool EdgeSE2Segment2DPointLine::setMeasurementData(const double* d) {
  setMeasurement(Vector3(d));
  return true;
}

bool EdgeSE2Segment2DPointLine::getMeasurementData(double* d) const {
  std::copy_n(_measurement.data(), 3, d);
  return true;
}

bool EdgeSE2Segment2DPointLine::setMeasurementFromState() {
  setMeasurement(error_of(End(Vector3::Zero(), _pointNum != 0), *this));
  return true;
}

}  // namespace g2o
