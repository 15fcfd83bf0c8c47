// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SBA_VERTEXINTRINSICS_H
#define G2O_SBA_VERTEXINTRINSICS_H

#include "g2o/core/base_vertex.h"
#include "g2o/types/sba/g2o_types_sba_api.h"

namespace g2o {

/// The intrinsics fx, fy, cx and cy of a camera, and its baseline. ⊞ adds the increment to fx, fy, cx and cy.
/// Tag: VERTEX_INTRINSICS.
class G2O_TYPES_SBA_API VertexIntrinsics
    : public BaseVertex<4, Eigen::Matrix<double, 5, 1, Eigen::ColMajor>> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  VertexIntrinsics();

  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

 protected:
  /// Sets fx, fy, cx, cy and the baseline to 1, 1, 0.5, 0.5 and 0.1.
  void setToOriginImpl() override;
  using OptimizableGraph::Vertex::oplusImpl;
  void oplusImpl(double* update) override;
};

}  // namespace g2o

#endif  // G2O_SBA_VERTEXINTRINSICS_H
