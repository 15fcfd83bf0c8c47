// SPDX-License-Identifier: BSD-3-Clause
// The reprojection errors of a file of bundle adjustment are those of the graph.
#pragma once

#include <string_view>

#include "boxplus/base/matrix.h"
#include "boxplus/graph/handle.h"

namespace boxplus {

/// The name of an observation in messages: "image 3 and point 7".
struct ObservationName {
  std::string_view image;  ///< the word for an image
  Id image_id, point_id;
};

/// Files have the poses of cameras in another form than the graph, and BAL's pixels have another origin. The
/// conversion rounds. Throws InvalidArgument, which names the observation, if the reprojection error that a
/// reader of the file computes is not as large as that of the graph up to 1e-4 pixels and 1e-4 of itself. An
/// error of the graph that is not finite is not compared. `format` is the text "a COLMAP model".
void require_equal_error(std::string_view format, const ObservationName& name, const Vector2& of_graph,
                         const Vector2& of_file);

}  // namespace boxplus
