// SPDX-License-Identifier: BSD-3-Clause
// Similarities whose ⊞ is the exponential map, and edges for similarities and image points.
#pragma once
#ifndef G2O_SEVEN_DOF_EXPMAP_TYPES
#define G2O_SEVEN_DOF_EXPMAP_TYPES

#include "g2o/types/sba/types_sba.h"
#include "g2o/types/sba/types_six_dof_expmap.h"
#include "g2o/types/sim3/edge_sim3.h"
#include "g2o/types/sim3/edge_sim3_project_xyz.h"
#include "g2o/types/sim3/sim3.h"
#include "g2o/types/sim3/vertex_sim3_expmap.h"

#endif  // G2O_SEVEN_DOF_EXPMAP_TYPES
