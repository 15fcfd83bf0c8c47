// SPDX-License-Identifier: BSD-3-Clause
// VRML 2.0 (ISO/IEC 14772-1:1997, "VRML97"), for viewers of scenes. boxplus only writes it.
#pragma once

#include "boxplus/io/file_format.h"

namespace boxplus {

/// The points and lines of a PointCloud (io/ply/point_cloud.h). If there are no cameras, also a line for each
/// edge, from the first of its vertices that has a position to each other one. (With cameras, the rays to all
/// points would hide everything.)
FileFormat vrml_format();

}  // namespace boxplus
