// SPDX-License-Identifier: BSD-3-Clause
// The poses of a model of bundle adjustment.
#pragma once

#include "boxplus/io/sparse_model.h"
#include "boxplus/manifold/se3.h"

namespace boxplus {

/// Graphs have the inverses of the poses of files.
SE3 pose_of(const SparseModel::Pose& pose);
SparseModel::Pose pose_in_file(const SE3& pose);
/// The pose of an image, as T_world_camera.
SE3 pose_of(const SparseModel::Image& image);
}  // namespace boxplus
