// SPDX-License-Identifier: BSD-3-Clause
// The format of the data sets "Bundle adjustment in the large" (Agarwal, Snavely, Seitz and Szeliski, 2010):
//
//     cameras points observations
//     camera point x y                (a line per observation; the center of the image is 0)
//     rx ry rz tx ty tz f k1 k2       (per camera: rotation vector and translation of T_camera_world,
//     BalModel) x y z                           (per point)
//
// All are numbers, separated by blanks or newlines. In the graph, the cameras are vertices Product<SE3,
// BalCamera> with the ids 0, 1, … and T_world_camera. The points are vertices Vector3 with the ids after
// them, and are marked to be eliminated. The observations are edges Reprojection<BalCamera> with Ω = I.
#pragma once

#include <string>
#include <vector>

#include "boxplus/io/file_format.h"
#include "io/model/bal_vertex.h"

namespace boxplus {

FileFormat bal_format();

/// The number of values per camera.
inline constexpr int kBalCameraValues = 9;

GraphFile read_bal(const TextSource& text, const ReadOptions& options);
void write_bal(const GraphFileView& file, const WriteOptions& options, TextSink sink);
/// See losses().
std::vector<std::string> bal_losses(const GraphFileView& file);

}  // namespace boxplus
