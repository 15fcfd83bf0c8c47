// SPDX-License-Identifier: BSD-3-Clause
// Polygon files (Turk, "The PLY polygon file format", 1994), for viewers of point clouds. boxplus only writes
// them.
#pragma once

#include "boxplus/io/file_format.h"

namespace boxplus {

/// Poses and points become vertices with a color. A camera becomes a pyramid of five vertices and eight
/// edges. The numbers are binary (little-endian): such files are three times as small as text, and every
/// viewer reads them.
FileFormat ply_format();

}  // namespace boxplus
