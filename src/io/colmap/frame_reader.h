// SPDX-License-Identifier: BSD-3-Clause
// Reads the rigs and frames of a COLMAP model.
#pragma once

#include "io/colmap/model_input.h"

namespace boxplus {

/// Adds rigs and frames to a model that has its cameras and images. Throws InputError like read_model(), and
/// if a frame has a sensor of another rig, if an image is in no frame or in two, if a sensor with an image
/// has no pose on its rig, or if the pose that follows from the frame is not that of the image.
void read_frames(ModelInput& rigs, ModelInput& frames, SparseModel& model);

}  // namespace boxplus
