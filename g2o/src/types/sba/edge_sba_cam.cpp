// SPDX-License-Identifier: BSD-3-Clause
// Edges between two cameras.
#include "g2o/types/sba/edge_sba_cam.h"

#include <algorithm>
#include <utility>

#include "g2o/types/sba/edge_sba_scale.h"
#include "types/sba/adapters_sba.h"

namespace g2o {
namespace {

using Native = boxplus::Between<boxplus::SE3>;

/// A copy of the camera with another pose.
SBACam moved(const SBACam& cam, const SE3Quat& pose) {
  SBACam result = cam;
  result.setRotation(pose.rotation());
  result.setTranslation(pose.translation());
  return result;
}

}  // namespace

EdgeSBACam::EdgeSBACam() = default;

void EdgeSBACam::computeError() {
  _error = Native(adapters::pose(_measurement))
               .error(adapters::pose(vertexXn<0>()->estimate()), adapters::pose(vertexXn<1>()->estimate()));
}

// A step changes the translation of a camera in the world frame. For a pose of the engine, a step changes the
// translation in the body frame. Therefore, the Jacobians for the translations are multiplied by the rotation
// from the world to the camera.
void EdgeSBACam::linearizeOplus() {
  const SBACam &from = vertexXn<0>()->estimate(), &to = vertexXn<1>()->estimate();
  adapters::linearize(Native(adapters::pose(_measurement)),
                      adapters::Argument<boxplus::SE3>{adapters::pose(from), _jacobianOplusXi.data()},
                      adapters::Argument<boxplus::SE3>{adapters::pose(to), _jacobianOplusXj.data()});
  _jacobianOplusXi.leftCols<3>() *= from.w2n.leftCols<3>();
  _jacobianOplusXj.leftCols<3>() *= to.w2n.leftCols<3>();
}

bool EdgeSBACam::read(std::istream& is) {
  return adapters::read_edge<Native>(is, 7, _information,
                                     [this](const auto& z) { setMeasurement(adapters::to_se3quat(z)); });
}

bool EdgeSBACam::write(std::ostream& os) const {
  return adapters::write_edge(os, Native(adapters::pose(_measurement)), _information);
}

void EdgeSBACam::setMeasurement(const SE3Quat& meas) {
  _measurement = meas;
  _inverseMeasurement = meas.inverse();
}

bool EdgeSBACam::setMeasurementData(const double* d) {
  setMeasurement(SE3Quat(Eigen::Map<const Vector7>(d)));
  return true;
}

bool EdgeSBACam::getMeasurementData(double* d) const {
  const Vector7 v = _measurement.toVector();
  std::copy_n(v.data(), 7, d);
  return true;
}

bool EdgeSBACam::setMeasurementFromState() {
  setMeasurement(vertexXn<0>()->estimate().inverse() * vertexXn<1>()->estimate());
  return true;
}

double EdgeSBACam::initialEstimatePossible(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  return 1.;
}

void EdgeSBACam::initialEstimate(const OptimizableGraph::VertexSet& from, OptimizableGraph::Vertex*) {
  VertexCam *first = vertexXn<0>(), *second = vertexXn<1>();
  if (from.count(_vertices[0]) > 0) {
    second->setEstimate(moved(second->estimate(), first->estimate() * _measurement));
  } else {
    first->setEstimate(moved(first->estimate(), second->estimate() * _inverseMeasurement));
  }
}

EdgeSBAScale::EdgeSBAScale() {
  _measurement = 0;
}

void EdgeSBAScale::computeError() {
  _error[0] = _measurement -
              (vertexXn<1>()->estimate().translation() - vertexXn<0>()->estimate().translation()).norm();
}

void EdgeSBAScale::linearizeOplus() {
  const Vector3 d = vertexXn<1>()->estimate().translation() - vertexXn<0>()->estimate().translation();
  _jacobianOplusXi.setZero();
  _jacobianOplusXi.leftCols<3>() = d.stableNormalized().transpose();
  _jacobianOplusXj = -_jacobianOplusXi;
}

bool EdgeSBAScale::read(std::istream& is) {
  return adapters::read_measurement<double>(is, 1, _information, [this](double z) { setMeasurement(z); });
}

bool EdgeSBAScale::write(std::ostream& os) const {
  return adapters::write_measurement(os, _measurement, _information);
}

bool EdgeSBAScale::setMeasurementData(const double* d) {
  setMeasurement(*d);
  return true;
}

bool EdgeSBAScale::getMeasurementData(double* d) const {
  *d = _measurement;
  return true;
}

bool EdgeSBAScale::setMeasurementFromState() {
  setMeasurement((vertexXn<1>()->estimate().translation() - vertexXn<0>()->estimate().translation()).norm());
  return true;
}

double EdgeSBAScale::initialEstimatePossible(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  return 1.;
}

void EdgeSBAScale::initialEstimate(const OptimizableGraph::VertexSet& from, OptimizableGraph::Vertex*) {
  VertexCam *known = vertexXn<0>(), *to = vertexXn<1>();
  if (from.count(known) == 0) std::swap(known, to);
  const Vector3 direction =
      (to->estimate().translation() - known->estimate().translation()).stableNormalized();
  SBACam cam = to->estimate();
  cam.setTranslation(known->estimate().translation() + _measurement * direction);
  to->setEstimate(cam);
}

}  // namespace g2o
