// SPDX-License-Identifier: BSD-3-Clause
// The sizes of images that a graph does not know.
#pragma once

#include "boxplus/io/sparse_model.h"

namespace boxplus {

/// Makes an image large enough for its features, which are relative to the center of the image, and turns
/// their y axis.
void move_center(SparseModel::Camera& camera, SparseModel::Image& image);

/// Makes the images of a camera large enough for these features.
void enlarge(SparseModel::Camera& camera, const SparseModel::Image& image);

}  // namespace boxplus
