// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_VERTEX_SBA_POINTXYZ_H
#define G2O_VERTEX_SBA_POINTXYZ_H

#include "g2o/types/sba/g2o_types_sba_api.h"
#include "g2o/types/slam3d/vertex_pointxyz.h"

namespace g2o {

/// A 3-D point. Older clients use this name for VertexPointXYZ. Tag: VERTEX_XYZ.
class G2O_TYPES_SBA_API VertexSBAPointXYZ : public VertexPointXYZ {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  VertexSBAPointXYZ();
};

}  // namespace g2o

#endif  // G2O_VERTEX_SBA_POINTXYZ_H
