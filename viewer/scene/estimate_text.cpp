// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/scene/estimate_text.h"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include "boxplus/manifold/product.h"
#include "boxplus/manifold/se3.h"
#include "boxplus/types/ba.h"

namespace boxplus::viewer {
namespace {

/// Six digits, as in the fields of estimates.
std::string line(std::string_view name, std::initializer_list<double> values) {
  std::string text = fmt::format("{}:", name);
  for (const double value : values) text += fmt::format(" {:.6g}", value);
  return text + "\n";
}

std::string frame_lines(const detail::Frame& frame) {
  const auto& t = frame.translation;
  if (frame.dimension == 2) {
    const std::string position = line("position", {t[0], t[1]});
    if (!frame.has_rotation) return position;
    return position + line("angle", {std::atan2(frame.rotation[2], frame.rotation[0])});
  }
  const std::string position = line("position", {t[0], t[1], t[2]});
  if (!frame.has_rotation) return position;
  const Eigen::Quaterniond q(
      Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(frame.rotation.data()));
  return position + line("rotation", {q.x(), q.y(), q.z(), q.w()});
}

template <class Camera>
std::string camera_lines(const Camera& camera) {
  std::string lines;
  for (int i = 0; i < Camera::kSize; ++i)
    lines += line(Camera::Model::kParameters[i], {camera.parameters[i]});
  return lines;
}

/// The parameters of the camera that the estimate is or contains.
std::string camera_lines(const Graph& graph, VertexRef vertex) {
  const detail::VertexPool& pool = *graph.vertex_pools()[vertex.pool];
  std::string lines;
  detail::CameraList::for_each([&]<class Camera>() {
    using Posed = Product<SE3, Camera>;
    if (dynamic_cast<const detail::TypedVertexPool<Camera>*>(&pool) != nullptr)
      lines = camera_lines(graph.estimate(graph.typed<Camera>(vertex)));
    if (dynamic_cast<const detail::TypedVertexPool<Posed>*>(&pool) != nullptr)
      lines = camera_lines(graph.estimate(graph.typed<Posed>(vertex)).template get<1>());
  });
  return lines;
}

}  // namespace

std::string estimate_text(const Graph& graph, VertexRef vertex) {
  std::string lines;
  detail::Frame frame;
  if (graph.vertex_pools()[vertex.pool]->get_frame(vertex.slot, frame)) lines = frame_lines(frame);
  lines += camera_lines(graph, vertex);
  if (!lines.empty()) lines.pop_back();
  return lines;
}

}  // namespace boxplus::viewer
