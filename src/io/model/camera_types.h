// SPDX-License-Identifier: BSD-3-Clause
// COLMAP's camera models, and the vertices and edges that belong to them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "boxplus/graph/graph.h"
#include "boxplus/types/ba.h"

namespace boxplus {

/// One camera model. Functions that take a vertex or an edge expect those of this model.
struct CameraType {
  std::string_view name;
  int model_id;  ///< in binary files
  int parameters;
  int focal_lengths;
  /// Adds a camera as a parameter that is not fixed, except for its principal point, as in COLMAP.
  VertexRef (*add)(Graph& graph, Id id, const double* parameters);
  EdgeRef (*observe)(Graph& graph, const Vector2& pixel, VertexHandle<SE3> pose, VertexHandle<Vector3> point,
                     VertexRef camera);
  /// The same for a camera at `offset` (T_rig_camera) on a rig at `pose`.
  EdgeRef (*observe_on_rig)(Graph& graph, const Vector2& pixel, VertexHandle<SE3> pose,
                            VertexHandle<Vector3> point, VertexHandle<SE3> offset, VertexRef camera);
  bool (*is_pool)(const detail::VertexPool& pool);
  std::span<const double> (*values)(const Graph& graph, VertexRef camera);
  /// The measurement of a reprojection error of (pose, point, camera) or (pose, point, offset, camera);
  /// nullptr if the edge is of another type.
  const Vector2* (*pixel)(const Graph& graph, EdgeRef edge);
  /// The pixel of a point in the frame of the camera.
  Vector2 (*project)(const double* parameters, const Vector3& point);
};

/// All models, in the order of their ids.
std::span<const CameraType> camera_types();
/// nullptr if there is no such model.
const CameraType* find_camera_type(std::string_view name);
const CameraType* find_camera_type(std::uint64_t model_id);
/// The type of the cameras in a pool; nullptr if its vertices are no cameras.
const CameraType* camera_type_of(const detail::VertexPool& pool);
/// "SIMPLE_PINHOLE, PINHOLE, …".
std::string camera_type_names();

}  // namespace boxplus
