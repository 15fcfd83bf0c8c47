// SPDX-License-Identifier: BSD-3-Clause
// Measured positions of images (GPS) and directions of gravity, from a CSV file.
#pragma once

#include <cstddef>
#include <string>

#include "boxplus/io/graph_file.h"

namespace boxplus::app {

/// What a file of priors has given.
struct PositionPriors {
  std::size_t positions = 0, directions = 0;  ///< edges
  std::size_t others = 0;                     ///< rows whose images the model does not have
  std::size_t far = 0;                        ///< positions that did not count for the motion
  double scale = 1;                           ///< by which the model became larger
};

/// Reads priors on images of a COLMAP model, moves the whole model onto them by a similarity, and adds an
/// edge for each. The first row of the file names its columns, in any order:
///
///   image                       the name of an image of the model
///   x, y, z                     the position of the camera, in meters; z points up
///   sigma, or sigma_x, sigma_y, sigma_z      standard deviations in meters; 1 if there are no such columns
///   gx, gy, gz, gravity_sigma   the direction of gravity in the frame of the camera, and its standard
///                               deviation in radians (0.02 if there is no such column)
///
/// A row may leave its position or its direction empty. Throws FileError or InputError for a file that cannot
/// be read or names an image twice, and InvalidArgument if the graph is no COLMAP model, or if the priors do
/// not determine the similarity: without directions, positions of three images that are not on a line;
/// without positions, one direction, which turns the model upright. Positions that are more than three times
/// as far from the moved model as most do not count for the motion.
PositionPriors add_position_priors(GraphFile& file, const std::string& path);

}  // namespace boxplus::app
