// SPDX-License-Identifier: BSD-3-Clause
// Reads a COLMAP model, and makes a graph of it.
#pragma once

#include <string>
#include <vector>

#include "boxplus/io/sparse_model.h"
#include "io/colmap/model_input.h"

namespace boxplus {

/// Everything that is unusual about a model, but not an error.
using ModelNotes = std::vector<std::string>;

/// Throws InputError for fields that are missing or not finite, ids that are taken, and references to
/// cameras, images, 2-D points and points that do not exist. The model has no rigs and frames yet
/// (read_frames()).
SparseModel read_model(ModelInput& cameras, ModelInput& images, ModelInput& points);
/// Images, points and cameras that nothing refers to, duplicate observations, and observations that only
/// images or only tracks list.
ModelNotes unusual_parts(const SparseModel& model);
/// The graph that SparseModel describes. GraphFile::edges are the features that show a point, in the order of
/// the model.
GraphFile graph_of(SparseModel model);

/// Reads a pose. Throws InputError unless its quaternion has about length 1, and its values are moderate.
/// `owner` is the text "image 3".
SparseModel::Pose read_pose(ModelInput& in, const std::string& owner);

/// Graphs have the inverses of the poses of files.
SE3 pose_of(const SparseModel::Pose& pose);
SparseModel::Pose pose_in_file(const SE3& pose);
/// The pose of an image, as T_world_camera.
SE3 pose_of(const SparseModel::Image& image);
/// The reprojection error of a point that a feature shows.
Vector2 error_of(const SparseModel::Camera& camera, const SE3& T_world_camera,
                 const SparseModel::Feature& feature, const Vector3& point);

}  // namespace boxplus
