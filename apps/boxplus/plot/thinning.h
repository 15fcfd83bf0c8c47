// SPDX-License-Identifier: BSD-3-Clause
// Keeps only the visible elements of a scene, so that pictures of large graphs stay small.
#pragma once

#include "plot/scene.h"

namespace boxplus::app {

/// Joins steps of the trajectory that are shorter than `pixel` meters, and leaves out segments and spots that
/// cover each other: the one with the largest chi2 stays. If more than `most` segments remain, it uses larger
/// pixels. Every error above noise stays visible at its position.
Scene thinned(Scene scene, double pixel, std::size_t most);

}  // namespace boxplus::app
