// SPDX-License-Identifier: BSD-3-Clause
// Reads a COLMAP model.
#pragma once

#include <string>

#include "boxplus/io/sparse_model.h"
#include "io/colmap/model_input.h"

namespace boxplus {

/// Throws InputError for fields that are missing or not finite, ids that are taken, and references to
/// cameras, images, 2-D points and points that do not exist. The model has no rigs and frames yet
/// (read_frames()).
SparseModel read_model(ModelInput& cameras, ModelInput& images, ModelInput& points);

/// Reads a pose. Throws InputError unless its quaternion has about length 1, and its values are moderate.
/// `owner` is the text "image 3".
SparseModel::Pose read_pose(ModelInput& in, const std::string& owner);

}  // namespace boxplus
