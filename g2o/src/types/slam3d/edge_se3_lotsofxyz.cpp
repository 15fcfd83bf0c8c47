// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam3d/edge_se3_lotsofxyz.h"

#include "types/lots_of_points.h"
#include "types/slam3d/adapters_slam3d.h"

namespace g2o {
namespace {

struct Types {
  using One = boxplus::PointObservation3;
  using Many = boxplus::PointsObservation3;
  using Pose = boxplus::SE3;
  using PoseVertex = VertexSE3;
  using PointVertex = VertexPointXYZ;
  static Pose pose(const PoseVertex& v) { return adapters::pose(v); }
  static boxplus::Vector3 point(const PointVertex& v) { return adapters::point(v); }
};
using Native = adapters::LotsOfPoints<Types>;

}  // namespace

EdgeSE3LotsOfXYZ::EdgeSE3LotsOfXYZ() {
  setDimension(0);
}

void EdgeSE3LotsOfXYZ::resize(size_t size) {
  BaseVariableSizedEdge<-1, VectorX>::resize(size);
  const size_t points = size > 0 ? size - 1 : 0;
  if (points == _observedPoints) return;
  _observedPoints = static_cast<unsigned int>(points);
  setDimension(static_cast<int>(3 * points));
  _measurement.setZero(_dimension);
}

void EdgeSE3LotsOfXYZ::setSize(int vertices) {
  resize(vertices > 0 ? static_cast<size_t>(vertices) : 0);
}

bool EdgeSE3LotsOfXYZ::verticesFit() const {
  return Native::vertices_fit(_vertices) && _measurement.size() == _dimension;
}

void EdgeSE3LotsOfXYZ::computeError() {
  Native::compute_error(_vertices, _measurement, _error);
}

void EdgeSE3LotsOfXYZ::linearizeOplus() {
  Native::linearize(_vertices, _measurement, _jacobianOplus);
}

bool EdgeSE3LotsOfXYZ::read(std::istream& is) {
  return Native::read(is, _information, _measurement);
}

bool EdgeSE3LotsOfXYZ::write(std::ostream& os) const {
  return Native::write(os, _information, _measurement);
}

bool EdgeSE3LotsOfXYZ::setMeasurementData(const double* d) {
  _measurement = Eigen::Map<const VectorX>(d, _measurement.size());
  return true;
}

bool EdgeSE3LotsOfXYZ::getMeasurementData(double* d) const {
  Eigen::Map<VectorX>(d, _measurement.size()) = _measurement;
  return true;
}

bool EdgeSE3LotsOfXYZ::setMeasurementFromState() {
  _measurement.setZero();
  Native::compute_error(_vertices, _measurement, _error);
  _measurement = _error;
  return true;
}

double EdgeSE3LotsOfXYZ::initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                                 OptimizableGraph::Vertex* to) {
  return from.count(_vertices[0]) > 0 && to != _vertices[0] ? 1. : -1.;
}

void EdgeSE3LotsOfXYZ::initialEstimate(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex* to) {
  const Isometry3& pose = static_cast<const VertexSE3*>(_vertices[0])->estimate();
  for (size_t i = 1; i < _vertices.size(); ++i) {
    if (_vertices[i] != to) continue;
    const Vector3 z = _measurement.segment<3>(static_cast<Eigen::Index>(3 * (i - 1)));
    static_cast<VertexPointXYZ*>(_vertices[i])->setEstimate(pose * z);
  }
}

}  // namespace g2o
