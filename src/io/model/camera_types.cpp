// SPDX-License-Identifier: BSD-3-Clause
#include "io/model/camera_types.h"

#include <algorithm>
#include <array>

namespace boxplus {
namespace {

template <class Camera>
VertexRef add_camera(Graph& graph, Id id, const double* parameters) {
  constexpr int kCenter = Camera::Model::kFocalLengths;
  const auto vertex =
      graph.add_parameter(Camera(Eigen::Map<const Vector<double, Camera::kSize>>(parameters)), id);
  graph.unfix(vertex);
  graph.fix_directions(vertex, {kCenter, kCenter + 1});
  return vertex;
}

template <class Camera>
EdgeRef observe(Graph& graph, const Vector2& pixel, VertexHandle<SE3> pose, VertexHandle<Vector3> point,
                VertexRef camera) {
  return graph.add_edge(Reprojection<Camera>(pixel), pose, point, graph.typed<Camera>(camera));
}

template <class Camera>
EdgeRef observe_on_rig(Graph& graph, const Vector2& pixel, VertexHandle<SE3> pose,
                       VertexHandle<Vector3> point, VertexHandle<SE3> offset, VertexRef camera) {
  return graph.add_edge(Reprojection<Camera>(pixel), pose, point, offset, graph.typed<Camera>(camera));
}

template <class Camera>
bool is_pool(const detail::VertexPool& pool) {
  return dynamic_cast<const detail::TypedVertexPool<Camera>*>(&pool) != nullptr;
}

template <class Camera>
std::span<const double> values(const Graph& graph, VertexRef camera) {
  const Camera& value = graph.estimate(graph.typed<Camera>(camera));
  return {value.parameters.data(), std::size_t{Camera::kSize}};
}

template <class Camera, class... Vertex>
const Vector2* pixel_in(const detail::EdgePool& edges, EdgeRef edge) {
  const auto* pool = dynamic_cast<const detail::TypedEdgePool<Reprojection<Camera>, Vertex...>*>(&edges);
  return pool ? &pool->value(edge.slot).measurement : nullptr;
}

template <class Camera>
const Vector2* pixel(const Graph& graph, EdgeRef edge) {
  const detail::EdgePool& edges = *graph.edge_pools()[edge.pool];
  const Vector2* const found = pixel_in<Camera, SE3, Vector3, Camera>(edges, edge);
  return found ? found : pixel_in<Camera, SE3, Vector3, SE3, Camera>(edges, edge);
}

template <class Camera>
Vector2 project(const double* parameters, const Vector3& point) {
  return Camera(Eigen::Map<const Vector<double, Camera::kSize>>(parameters)).project(point);
}

template <class Camera>
constexpr CameraType type_of() {
  return {Camera::kName,          Camera::Model::kColmapId,
          Camera::kSize,          Camera::Model::kFocalLengths,
          add_camera<Camera>,     observe<Camera>,
          observe_on_rig<Camera>, is_pool<Camera>,
          values<Camera>,         pixel<Camera>,
          project<Camera>};
}

template <class Camera>
constexpr bool kIsOfColmap = requires {
  Camera::Model::kColmapId;
};

template <class... Camera>
constexpr auto types_of(detail::CameraTypes<Camera...> cameras) {
  std::array<CameraType, (std::size_t{kIsOfColmap<Camera>} + ...)> types{};
  auto next = types.begin();
  cameras.for_each([&]<class C>() {
    if constexpr (kIsOfColmap<C>) *next++ = type_of<C>();
  });
  std::sort(types.begin(), types.end(),
            [](const CameraType& a, const CameraType& b) { return a.model_id < b.model_id; });
  return types;
}

constexpr auto kTypes = types_of(detail::CameraList());

template <class Predicate>
const CameraType* find(Predicate predicate) {
  const auto* const found = std::find_if(kTypes.begin(), kTypes.end(), predicate);
  return found == kTypes.end() ? nullptr : found;
}

}  // namespace

std::span<const CameraType> camera_types() {
  return kTypes;
}

const CameraType* find_camera_type(std::string_view name) {
  return find([name](const CameraType& type) { return type.name == name; });
}

const CameraType* find_camera_type(std::uint64_t model_id) {
  return find(
      [model_id](const CameraType& type) { return static_cast<std::uint64_t>(type.model_id) == model_id; });
}

const CameraType* camera_type_of(const detail::VertexPool& pool) {
  return find([&pool](const CameraType& type) { return type.is_pool(pool); });
}

std::string camera_type_names() {
  std::string names;
  for (const CameraType& type : kTypes) names += (names.empty() ? "" : ", ") + std::string(type.name);
  return names;
}

}  // namespace boxplus
