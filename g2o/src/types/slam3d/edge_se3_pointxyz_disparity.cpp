// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam3d/edge_se3_pointxyz_disparity.h"

#include <algorithm>

#include "types/slam3d/depth_image.h"

namespace g2o {
namespace {

using Native = boxplus::DisparityImage;

}  // namespace

EdgeSE3PointXYZDisparity::EdgeSE3PointXYZDisparity() {
  _measurement.setZero();
  resizeParameters(1);
  installParameter(params, 0);
}

void EdgeSE3PointXYZDisparity::computeError() {
  _error = adapters::depth_image_error<Native>(_measurement, *vertexXn<0>(), *vertexXn<1>(), *params);
}

void EdgeSE3PointXYZDisparity::linearizeOplus() {
  adapters::linearize_depth_image<Native>(*vertexXn<0>(), *vertexXn<1>(), *params, _jacobianOplusXi,
                                          _jacobianOplusXj);
}

bool EdgeSE3PointXYZDisparity::read(std::istream& is) {
  return readParamIds(is) && adapters::read_measurement<boxplus::Vector3>(
                                 is, 3, _information, [this](const auto& z) { setMeasurement(z); });
}

bool EdgeSE3PointXYZDisparity::write(std::ostream& os) const {
  return writeParamIds(os) && adapters::write_measurement(os, boxplus::Vector3(_measurement), _information);
}

bool EdgeSE3PointXYZDisparity::setMeasurementData(const double* d) {
  setMeasurement(Vector3(d[0], d[1], d[2]));
  return true;
}

bool EdgeSE3PointXYZDisparity::getMeasurementData(double* d) const {
  std::copy_n(_measurement.data(), 3, d);
  return true;
}

bool EdgeSE3PointXYZDisparity::setMeasurementFromState() {
  setMeasurement(
      adapters::depth_image_error<Native>(Vector3::Zero(), *vertexXn<0>(), *vertexXn<1>(), *params));
  return true;
}

double EdgeSE3PointXYZDisparity::initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                                         OptimizableGraph::Vertex* to) {
  return from.count(_vertices[0]) > 0 && to == vertexXn<1>() ? 1. : -1.;
}

void EdgeSE3PointXYZDisparity::initialEstimate(const OptimizableGraph::VertexSet&,
                                               OptimizableGraph::Vertex*) {
  const Vector3 p =
      (1 / _measurement[2]) * (params->invKcam() * Vector3(_measurement[0], _measurement[1], 1));
  vertexXn<1>()->setEstimate(vertexXn<0>()->estimate() * (params->offset() * p));
}

}  // namespace g2o
