// SPDX-License-Identifier: BSD-3-Clause
// The places of image poses in the graph of a COLMAP model.
#pragma once

#include <optional>
#include <vector>

#include "boxplus/io/sparse_model.h"
#include "boxplus/manifold/se3.h"

namespace boxplus {

/// T_world_camera = T_world_rig · T_rig_camera. An image that moves on its own, and an image of the reference
/// sensor, have no offset.
struct PosePlace {
  Id vertex = 0;
  SE3 T_world_rig;           ///< of the vertex, as in the model
  std::optional<Id> offset;  ///< the parameter of T_rig_camera
  SE3 T_rig_camera;          ///< as in the model

  SE3 T_world_camera() const { return offset ? T_world_rig * T_rig_camera : T_world_rig; }
};

/// The places for all images, in the order of the model. All images of a model with frames must be in frames.
std::vector<PosePlace> pose_places(const SparseModel& model);

}  // namespace boxplus
