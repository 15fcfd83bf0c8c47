// SPDX-License-Identifier: BSD-3-Clause
// The common part of the library: graphs, poses, optimize(), covariances, and files. The other parts have
// separate headers:
//
//     types/slam2d.h, types/slam3d.h       all ready-made edges in 2-D and in 3-D
//     types/ba.h                           cameras and reprojection errors, for bundle adjustment
//     types/ba/bundle_parts.h              holds poses, points or intrinsics of bundle adjustment
//     types/dense_prior.h                  a prior on several vertices at once
//     types/inertial.h                     IMU, directions, magnetic field, time offsets
//     types/hand_eye.h                     hand-eye calibration
//     types/slam2d/calibrate_drive.h       a start for the calibration of a differential drive
//     manifold/so2.h, s2.h, sim3.h         rotations in 2-D, directions, similarities
//     manifold/convert_to.h                poses of Eigen, Sophus and other libraries
//     robust/huber.h, redescending.h,      robust kernels; make_robust_kernel() makes them by name
//     robust/barron.h, default_width.h
//     io/registry.h, file_format.h, data.h custom file tags and formats; data in files
//     algorithm/algorithm.h                custom algorithms
//     certify/certificate.h                whether the minimum of a pose graph is global
//     diagnose/diagnose.h                  what is wrong with a graph
//     outliers/outliers.h                  which edges are false
//     incremental/smoother.h               keeps a graph at its optimum while it grows and changes
//     incremental/marginalize.h            replaces vertices by a prior on their neighbors
//     linear/linear_solver.h               custom linear solvers
//     testing/check_jacobians.h, …         checks of custom types
#pragma once

// IWYU pragma: begin_exports
#include "boxplus/base/error.h"
#include "boxplus/covariance/covariance.h"
#include "boxplus/graph/graph.h"
#include "boxplus/io/graph_file.h"
#include "boxplus/manifold/product.h"
#include "boxplus/manifold/rn.h"
#include "boxplus/manifold/se2.h"
#include "boxplus/manifold/se3.h"
#include "boxplus/manifold/so3.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/robust/make_robust_kernel.h"
#include "boxplus/types/between.h"
#include "boxplus/types/prior.h"
#include "boxplus/types/range.h"
// IWYU pragma: end_exports
