// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam3d/edge_se3_pointxyz.h"

#include <algorithm>

#include "types/slam3d/adapters_slam3d.h"

namespace g2o {
namespace {

using Native = boxplus::OffsetPointObservation3;

}  // namespace

EdgeSE3PointXYZ::EdgeSE3PointXYZ() {
  _measurement.setZero();
  resizeParameters(1);
  installParameter(offsetParam, 0);
}

void EdgeSE3PointXYZ::computeError() {
  _error = Native(adapters::point(_measurement))
               .error(adapters::pose(*vertexXn<0>()), adapters::point(*vertexXn<1>()),
                      adapters::pose(*offsetParam));
}

void EdgeSE3PointXYZ::linearizeOplus() {
  adapters::linearize(
      Native(adapters::point(_measurement)),
      adapters::Argument<boxplus::SE3>{adapters::pose(*vertexXn<0>()), std::get<0>(_jacobianOplus).data()},
      adapters::Argument<boxplus::Vector3>{adapters::point(*vertexXn<1>()),
                                           std::get<1>(_jacobianOplus).data()},
      adapters::Argument<boxplus::SE3>{adapters::pose(*offsetParam), nullptr});
}

bool EdgeSE3PointXYZ::read(std::istream& is) {
  return readParamIds(is) &&
         adapters::read_edge<Native>(is, 3, _information, [this](const auto& z) { setMeasurement(z); });
}

bool EdgeSE3PointXYZ::write(std::ostream& os) const {
  return writeParamIds(os) && adapters::write_edge(os, Native(adapters::point(_measurement)), _information);
}

bool EdgeSE3PointXYZ::setMeasurementData(const double* d) {
  setMeasurement(Vector3(d[0], d[1], d[2]));
  return true;
}

bool EdgeSE3PointXYZ::getMeasurementData(double* d) const {
  std::copy_n(_measurement.data(), 3, d);
  return true;
}

bool EdgeSE3PointXYZ::setMeasurementFromState() {
  setMeasurement((vertexXn<0>()->estimate() * offsetParam->offset()).inverse() * vertexXn<1>()->estimate());
  return true;
}

double EdgeSE3PointXYZ::initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                                OptimizableGraph::Vertex* to) {
  return from.count(_vertices[0]) > 0 && to == vertexXn<1>() ? 1. : -1.;
}

void EdgeSE3PointXYZ::initialEstimate(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) {
  vertexXn<1>()->setEstimate(vertexXn<0>()->estimate() * (offsetParam->offset() * _measurement));
}

}  // namespace g2o
