// SPDX-License-Identifier: BSD-3-Clause
// The visible parts of a graph of bundle adjustment: its points, with the errors of their observations, and
// its cameras.
#pragma once

#include <string>

#include "plot/scene.h"

namespace boxplus::app {

/// Makes the scene of a graph of bundle adjustment. It encloses most points, so that a few distant points do
/// not make everything else tiny. Points outside are left out and counted. A line joins each camera with its
/// true place.
Scene make_bundle_scene(const Graph& graph, std::string title, const View& view, const TruePlaces& truth);

}  // namespace boxplus::app
