// SPDX-License-Identifier: BSD-3-Clause
// What of a scene can be seen: pictures of large graphs stay small.
#pragma once

#include "plot/scene.h"

namespace boxplus::app {

/// Joins steps of the trajectory that are shorter than `pixel` metres, and leaves out segments and spots that
/// lie on others: the one with the largest chi2 stays. Where still more than `most` segments are left, larger
/// pixels are taken. Every error above noise stays visible where it was.
Scene thinned(Scene scene, double pixel, std::size_t most);

}  // namespace boxplus::app
