// SPDX-License-Identifier: BSD-3-Clause
// The types for sparse bundle adjustment.
#pragma once
#ifndef G2O_SBA_TYPES
#define G2O_SBA_TYPES

#include "g2o/types/sba/edge_project_p2mc.h"
#include "g2o/types/sba/edge_project_p2sc.h"
#include "g2o/types/sba/edge_sba_cam.h"
#include "g2o/types/sba/edge_sba_scale.h"
#include "g2o/types/sba/sbacam.h"
#include "g2o/types/sba/vertex_cam.h"
#include "g2o/types/sba/vertex_intrinsics.h"
#include "g2o/types/sba/vertex_sba_pointxyz.h"
#include "g2o/types/slam3d/vertex_pointxyz.h"

#endif  // G2O_SBA_TYPES
