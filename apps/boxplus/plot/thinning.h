// SPDX-License-Identifier: BSD-3-Clause
// Keeps only the visible elements of a scene, so that the picture files of large graphs stay small.
#pragma once

#include "plot/scene.h"

namespace boxplus::app {

/// Joins steps of the trajectory that are shorter than `pixel` meters. If segments or spots cover each other,
/// keeps only the one with the largest chi2. If more than `most` elements remain, repeats this with larger
/// pixels. Every error that is larger than noise stays visible at its position.
Scene thinned(Scene scene, double pixel, std::size_t most);

}  // namespace boxplus::app
