// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_PROJECT_DISPARITY_H_
#define G2O_EDGE_PROJECT_DISPARITY_H_

#include "g2o/core/base_binary_edge.h"
#include "g2o/types/slam3d/parameter_camera.h"
#include "g2o/types/slam3d/vertex_pointxyz.h"
#include "g2o/types/slam3d/vertex_se3.h"

namespace g2o {

/// The measured image position (pixels) and inverse depth (1/meters) of a point, z = (u, v, 1/depth), in a
/// camera on a robot. Error: (u, v, 1/depth) − z. Tag: EDGE_PROJECT_DISPARITY.
class G2O_TYPES_SLAM3D_API EdgeSE3PointXYZDisparity
    : public BaseBinaryEdge<3, Vector3, VertexSE3, VertexPointXYZ> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgeSE3PointXYZDisparity();

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

/// The action "draw" of EdgeSE3PointXYZDisparity.
class G2O_TYPES_SLAM3D_API EdgeProjectDisparityDrawAction : public internal::NamedAction<DrawAction> {
 public:
  EdgeProjectDisparityDrawAction();
};

}  // namespace g2o

#endif  // G2O_EDGE_PROJECT_DISPARITY_H_
