// SPDX-License-Identifier: BSD-3-Clause
// Camera poses whose ⊞ is the exponential map, and edges for image points of these cameras.
#pragma once
#ifndef G2O_SIX_DOF_TYPES_EXPMAP
#define G2O_SIX_DOF_TYPES_EXPMAP

#include "g2o/types/sba/edge_project_psi2uv.h"
#include "g2o/types/sba/edge_project_stereo_xyz.h"
#include "g2o/types/sba/edge_project_stereo_xyz_onlypose.h"
#include "g2o/types/sba/edge_project_xyz.h"
#include "g2o/types/sba/edge_project_xyz2uv.h"
#include "g2o/types/sba/edge_project_xyz2uvu.h"
#include "g2o/types/sba/edge_project_xyz_onlypose.h"
#include "g2o/types/sba/edge_se3_expmap.h"
#include "g2o/types/sba/parameter_cameraparameters.h"
#include "g2o/types/sba/types_sba.h"
#include "g2o/types/sba/vertex_se3_expmap.h"
#include "g2o/types/slam3d/se3_ops.h"
#include "g2o/types/slam3d/se3quat.h"

#endif  // G2O_SIX_DOF_TYPES_EXPMAP
