// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam2d/edge_se2_lotsofxy.h"

#include "types/lots_of_points.h"
#include "types/slam2d/adapters_slam2d.h"

namespace g2o {
namespace {

struct Types {
  using One = boxplus::PointObservation2;
  using Many = boxplus::PointsObservation2;
  using Pose = boxplus::SE2;
  using PoseVertex = VertexSE2;
  using PointVertex = VertexPointXY;
  static Pose pose(const PoseVertex& v) { return adapters::pose(v); }
  static boxplus::Vector2 point(const PointVertex& v) { return adapters::point(v); }
};
using Native = adapters::LotsOfPoints<Types>;

}  // namespace

EdgeSE2LotsOfXY::EdgeSE2LotsOfXY() {
  setDimension(0);
}

void EdgeSE2LotsOfXY::resize(size_t size) {
  BaseVariableSizedEdge<-1, VectorX>::resize(size);
  const size_t points = size > 0 ? size - 1 : 0;
  if (points == _observedPoints) return;
  _observedPoints = static_cast<unsigned int>(points);
  setDimension(static_cast<int>(2 * points));
  _measurement.setZero(_dimension);
}

void EdgeSE2LotsOfXY::setSize(int vertices) {
  resize(vertices > 0 ? static_cast<size_t>(vertices) : 0);
}

bool EdgeSE2LotsOfXY::verticesFit() const {
  return Native::vertices_fit(_vertices) && _measurement.size() == _dimension;
}

void EdgeSE2LotsOfXY::computeError() {
  Native::compute_error(_vertices, _measurement, _error);
}

void EdgeSE2LotsOfXY::linearizeOplus() {
  Native::linearize(_vertices, _measurement, _jacobianOplus);
}

bool EdgeSE2LotsOfXY::read(std::istream& is) {
  return Native::read(is, _information, _measurement);
}

bool EdgeSE2LotsOfXY::write(std::ostream& os) const {
  return Native::write(os, _information, _measurement);
}

bool EdgeSE2LotsOfXY::setMeasurementData(const double* d) {
  _measurement = Eigen::Map<const VectorX>(d, _measurement.size());
  return true;
}

bool EdgeSE2LotsOfXY::getMeasurementData(double* d) const {
  Eigen::Map<VectorX>(d, _measurement.size()) = _measurement;
  return true;
}

bool EdgeSE2LotsOfXY::setMeasurementFromState() {
  _measurement.setZero();
  Native::compute_error(_vertices, _measurement, _error);
  _measurement = _error;
  return true;
}

double EdgeSE2LotsOfXY::initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                                OptimizableGraph::Vertex* to) {
  return from.count(_vertices[0]) > 0 && to != _vertices[0] ? 1. : -1.;
}

void EdgeSE2LotsOfXY::initialEstimate(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex* to) {
  const SE2& pose = static_cast<const VertexSE2*>(_vertices[0])->estimate();
  for (size_t i = 1; i < _vertices.size(); ++i) {
    if (_vertices[i] != to) continue;
    const Vector2 z = _measurement.segment<2>(static_cast<Eigen::Index>(2 * (i - 1)));
    static_cast<VertexPointXY*>(_vertices[i])->setEstimate(pose * z);
  }
}

}  // namespace g2o
