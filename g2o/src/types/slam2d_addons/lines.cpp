// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "g2o/types/slam2d_addons/edge_line2d.h"
#include "g2o/types/slam2d_addons/edge_line2d_pointxy.h"
#include "g2o/types/slam2d_addons/edge_se2_line2d.h"
#include "types/slam2d_addons/adapters_slam2d_addons.h"

namespace g2o {
namespace {

using Observation = boxplus::LineObservation2;
using Difference = boxplus::LineDifference2;
using Distance = boxplus::PointToLine2;

}  // namespace

EdgeSE2Line2D::EdgeSE2Line2D() = default;

void EdgeSE2Line2D::computeError() {
  _error = Observation(_measurement).error(adapters::pose(*vertexXn<0>()), adapters::line(*vertexXn<1>()));
}

void EdgeSE2Line2D::linearizeOplus() {
  adapters::linearize(
      Observation(_measurement),
      adapters::Argument<boxplus::SE2>{adapters::pose(*vertexXn<0>()), _jacobianOplusXi.data()},
      adapters::Argument<boxplus::Line2>{adapters::line(*vertexXn<1>()), _jacobianOplusXj.data()});
}

bool EdgeSE2Line2D::read(std::istream& is) {
  return adapters::read_edge<Observation>(is, 2, _information,
                                          [this](const auto& z) { setMeasurement(Vector2(z)); });
}

bool EdgeSE2Line2D::write(std::ostream& os) const {
  return adapters::write_edge(os, Observation(_measurement), _information);
}

bool EdgeSE2Line2D::setMeasurementData(const double* d) {
  setMeasurement(Vector2(d));
  return true;
}

bool EdgeSE2Line2D::getMeasurementData(double* d) const {
  std::copy_n(_measurement.data(), 2, d);
  return true;
}

bool EdgeSE2Line2D::setMeasurementFromState() {
  setMeasurement(vertexXn<0>()->estimate().inverse() * vertexXn<1>()->estimate());
  return true;
}

double EdgeSE2Line2D::initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                              OptimizableGraph::Vertex* to) {
  return from.count(_vertices[0]) > 0 && to == vertexXn<1>() ? 1. : -1.;
}

void EdgeSE2Line2D::initialEstimate(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  vertexXn<1>()->setEstimate(vertexXn<0>()->estimate() * _measurement);
}

EdgeLine2D::EdgeLine2D() = default;

void EdgeLine2D::computeError() {
  _error = Difference(_measurement).error(adapters::line(*vertexXn<0>()), adapters::line(*vertexXn<1>()));
}

void EdgeLine2D::linearizeOplus() {
  adapters::linearize(
      Difference(_measurement),
      adapters::Argument<boxplus::Line2>{adapters::line(*vertexXn<0>()), _jacobianOplusXi.data()},
      adapters::Argument<boxplus::Line2>{adapters::line(*vertexXn<1>()), _jacobianOplusXj.data()});
}

bool EdgeLine2D::read(std::istream& is) {
  return adapters::read_edge<Difference>(is, 2, _information,
                                         [this](const auto& z) { setMeasurement(Vector2(z)); });
}

bool EdgeLine2D::write(std::ostream& os) const {
  return adapters::write_edge(os, Difference(_measurement), _information);
}

bool EdgeLine2D::setMeasurementData(const double* d) {
  setMeasurement(Vector2(d));
  return true;
}

bool EdgeLine2D::getMeasurementData(double* d) const {
  std::copy_n(_measurement.data(), 2, d);
  return true;
}

bool EdgeLine2D::setMeasurementFromState() {
  const VertexLine2D &from = *vertexXn<0>(), &to = *vertexXn<1>();
  setMeasurement(Vector2(normalize_theta(to.theta() - from.theta()), to.rho() - from.rho()));
  return true;
}

double EdgeLine2D::initialEstimatePossible(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  return 1.;
}

void EdgeLine2D::initialEstimate(const OptimizableGraph::VertexSet& from, OptimizableGraph::Vertex*) {
  const bool forward = from.count(_vertices[0]) > 0;
  const double sign = forward ? 1 : -1;
  const VertexLine2D& known = forward ? *vertexXn<0>() : *vertexXn<1>();
  VertexLine2D& guessed = forward ? *vertexXn<1>() : *vertexXn<0>();
  guessed.setTheta(normalize_theta(known.theta() + sign * _measurement[0]));
  guessed.setRho(known.rho() + sign * _measurement[1]);
}

EdgeLine2DPointXY::EdgeLine2DPointXY() {
  _measurement = 0;
}

void EdgeLine2DPointXY::computeError() {
  _error[0] = Distance(_measurement).error(adapters::line(*vertexXn<0>()), adapters::point(*vertexXn<1>()));
}

void EdgeLine2DPointXY::linearizeOplus() {
  adapters::linearize(
      Distance(_measurement),
      adapters::Argument<boxplus::Line2>{adapters::line(*vertexXn<0>()), _jacobianOplusXi.data()},
      adapters::Argument<boxplus::Vector2>{adapters::point(*vertexXn<1>()), _jacobianOplusXj.data()});
}

bool EdgeLine2DPointXY::read(std::istream& is) {
  return adapters::read_edge<Distance>(is, 1, _information, [this](double z) { setMeasurement(z); });
}

bool EdgeLine2DPointXY::write(std::ostream& os) const {
  return adapters::write_edge(os, Distance(_measurement), _information);
}

bool EdgeLine2DPointXY::setMeasurementData(const double* d) {
  setMeasurement(d[0]);
  return true;
}

bool EdgeLine2DPointXY::getMeasurementData(double* d) const {
  d[0] = _measurement;
  return true;
}

bool EdgeLine2DPointXY::setMeasurementFromState() {
  computeError();
  setMeasurement(_measurement + _error[0]);
  return true;
}

}  // namespace g2o
