// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_PROJECT_DEPTH_H_
#define G2O_EDGE_PROJECT_DEPTH_H_

#include "g2o/core/base_binary_edge.h"
#include "g2o/types/slam3d/parameter_camera.h"
#include "g2o/types/slam3d/vertex_pointxyz.h"
#include "g2o/types/slam3d/vertex_se3.h"

namespace g2o {

/// The measured image position (pixels) and depth (meters) of a point, z = (u, v, depth), in a camera on a
/// robot. Error: (u, v, depth) − z. Tag: EDGE_PROJECT_DEPTH.
class G2O_TYPES_SLAM3D_API EdgeSE3PointXYZDepth
    : public BaseBinaryEdge<3, Vector3, VertexSE3, VertexPointXYZ> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgeSE3PointXYZDepth();

  void computeError() override;
  void linearizeOplus() override;
  using BaseBinaryEdge<3, Vector3, VertexSE3, VertexPointXYZ>::linearizeOplus;
  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;
  const ParameterCamera* cameraParameter() const { return params; }

  bool setMeasurementData(const double* d) override;
  bool getMeasurementData(double* d) const override;
  int measurementDimension() const override { return 3; }
  bool setMeasurementFromState() override;

  double initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                 OptimizableGraph::Vertex* to) override;
  void initialEstimate(const OptimizableGraph::VertexSet& from, OptimizableGraph::Vertex* to) override;

 protected:
  ParameterCamera* params = nullptr;
};

}  // namespace g2o

#endif  // G2O_EDGE_PROJECT_DEPTH_H_
