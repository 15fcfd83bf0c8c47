// SPDX-License-Identifier: BSD-3-Clause
// The rigs and frames of the COLMAP model of a graph.
#pragma once

#include "boxplus/io/sparse_model.h"
#include "io/model/graph_roles.h"

namespace boxplus {

/// Adds the rigs and frames of `old`, from which the graph was read, with the poses of the graph, to a model
/// that has all else. Images that are gone leave their frames, and frames without any of their images are
/// left out. A new image becomes a frame of a rig whose reference sensor is its camera; such a rig is added
/// if the camera is on no rig. Throws InvalidArgument if a camera of a rig is gone, if an image has another
/// camera than its frame has, or if a new image has a camera that another sensor carries.
void add_frames(SparseModel& model, const SparseModel& old, const GraphRoles& roles);

}  // namespace boxplus
