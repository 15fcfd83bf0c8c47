// SPDX-License-Identifier: BSD-3-Clause
// Stereo cameras of g2o's types sba as poses with a camera, of the types slam3d.
#pragma once

#include "boxplus/io/graph_file.h"

namespace boxplus::app {

/// Makes each VERTEX_CAM a VERTEX_SE3:QUAT with the same id, and adds a parameter PARAMS_CAMERACALIB per set
/// of intrinsics. With bf = fx · baseline:
///
///     EDGE_PROJECT_P2SC (u, v, u_right)   EDGE_PROJECT_DISPARITY (u, v, (u − u_right)/bf) and JᵀΩJ, with J =
///                                         ∂(u, v, u_right)/∂(u, v, 1/z) = [1 0 0; 0 1 0; 1 0 −bf]
///     EDGE_PROJECT_P2MC (u, v)            EDGE_PROJECT_DISPARITY (u, v, 0), with Ω zero for the last row
///     EDGE_CAM                            EDGE_SE3:QUAT
///
/// J is constant, so chi2 is the same for all estimates. Throws InvalidArgument if there is no VERTEX_CAM, an
/// edge has no counterpart, or a camera with EDGE_PROJECT_P2SC has bf = 0.
void stereo_to_slam3d(GraphFile& file);

}  // namespace boxplus::app
