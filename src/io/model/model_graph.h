// SPDX-License-Identifier: BSD-3-Clause
// The graph of a model of bundle adjustment.
#pragma once

#include <string>
#include <vector>

#include "boxplus/io/graph_file.h"
#include "boxplus/io/sparse_model.h"
#include "io/model/model_pose.h"

namespace boxplus {

/// Everything that is unusual about a model, but not an error.
using ModelNotes = std::vector<std::string>;

/// Images, points and cameras that nothing refers to, duplicate observations, and observations that only
/// images or only tracks list.
ModelNotes unusual_parts(const SparseModel& model);
/// The graph that SparseModel describes. GraphFile::edges are the features that show a point, in the order of
/// the model.
GraphFile graph_of(SparseModel model);

/// The reprojection error of a point that a feature shows.
Vector2 error_of(const SparseModel::Camera& camera, const SE3& T_world_camera,
                 const SparseModel::Feature& feature, const Vector3& point);

}  // namespace boxplus
