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

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "boxplus/io/file_format.h"
#include "io/model/bal_vertex.h"

namespace boxplus {

FileFormat bal_format();

/// The number of values per camera.
inline constexpr int kBalCameraValues = 9;

GraphFile read_bal(const TextSource& text, const ReadOptions& options);

/// Called for the counts of cameras, points and observations, and then for each observation: the indices of
/// camera and point, and the pixel.
struct BalVisitor {
  std::function<void(std::span<const double>)> counts, observation;
};
/// Throws what read_bal() throws.
void visit_bal(const TextSource& text, const ReadOptions& options, const BalVisitor& visitor);

/// Who observes whom, without the coordinates.
struct BalObservations {
  std::uint32_t cameras = 0, points = 0;
  std::vector<std::uint64_t> pairs;  ///< (point << 32) + camera, in the order of the file
};
/// Throws what read_bal() throws. Needs 8 bytes per observation.
BalObservations read_bal_observations(const TextSource& text, const ReadOptions& options);

/// Some of the points.
struct BalPoints {
  std::vector<bool> is_wanted;   ///< by index
  std::size_t observations = 0;  ///< of these points
};
/// Does the same as read_bal(), but leaves out other points and their observations. All cameras are there.
/// Vertices have the ids of the whole problem, and notes are about the whole file.
GraphFile read_bal_part(const TextSource& text, const ReadOptions& options, const BalPoints& points);

/// The vertices of read_bal(), without any edges.
GraphFile read_bal_vertices(const TextSource& text, const ReadOptions& options);

void write_bal(const GraphFileView& file, const WriteOptions& options, TextSink sink);
/// Does what write_bal() does if read_bal_vertices(text) has read the vertices, whose estimates may have
/// changed since then, and the edges are those of read_bal(text). Does not hold the edges.
void write_bal_vertices(const Graph& vertices, const TextSource& text, const ReadOptions& options,
                        TextSink sink);
/// See losses().
std::vector<std::string> bal_losses(const GraphFileView& file);

}  // namespace boxplus
