// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/ba/bundle_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <typeinfo>
#include <vector>

#include "boxplus/base/error.h"
#include "boxplus/types/ba/pools.h"

namespace boxplus {
namespace {

constexpr std::array kParts{BundlePart::kPoses,           BundlePart::kPoints,     BundlePart::kFocalLengths,
                            BundlePart::kPrincipalPoints, BundlePart::kDistortion, BundlePart::kIntrinsics};

/// The directions from `begin` to before `end` in the tangent space of a vertex.
struct Directions {
  int begin = 0, end = 0;
};

template <class T>
bool holds(const detail::VertexPool& pool) {
  return typeid(pool) == typeid(detail::TypedVertexPool<T>);
}

/// The parameters of a camera that belong to a part.
template <class Camera>
Directions range_in(BundlePart part) {
  using Model = typename Camera::Model;
  constexpr int kCenter = Model::kFocalLengths, kRest = kCenter + (Model::kHasCenter ? 2 : 0);
  switch (part) {
    case BundlePart::kFocalLengths:
      return {0, kCenter};
    case BundlePart::kPrincipalPoints:
      return {kCenter, kRest};
    case BundlePart::kDistortion:
      return {kRest, Camera::kSize};
    case BundlePart::kIntrinsics:
      return {0, Camera::kSize};
    default:
      return {};
  }
}

/// The directions of the vertices of a pool that belong to a part.
Directions range_in(const detail::VertexPool& pool, BundlePart part) {
  constexpr int kPose = 6, kPoint = 3;
  if (holds<SE3>(pool)) return {0, part == BundlePart::kPoses ? kPose : 0};
  if (holds<Vector3>(pool)) return {0, part == BundlePart::kPoints ? kPoint : 0};
  Directions range;
  detail::CameraList::for_each([&]<class Camera>() {
    if (holds<Camera>(pool)) range = range_in<Camera>(part);
    if (!holds<Product<SE3, Camera>>(pool)) return;
    const Directions intrinsics = range_in<Camera>(part);
    range = part == BundlePart::kPoses ? Directions{0, kPose}
                                       : Directions{kPose + intrinsics.begin, kPose + intrinsics.end};
  });
  return range;
}

/// Holds or frees a range of directions. All other directions stay as they are.
void hold(Graph& graph, VertexRef vertex, const Directions& range, bool held) {
  std::vector<bool> is_held(static_cast<std::size_t>(graph.tangent_dim(vertex)), graph.is_fixed(vertex));
  for (const int direction : graph.fixed_directions(vertex)) is_held[direction] = true;
  for (int k = range.begin; k < range.end; ++k) is_held[k] = held;
  std::vector<int> directions;
  for (std::size_t k = 0; k < is_held.size(); ++k) {
    if (is_held[k]) directions.push_back(static_cast<int>(k));
  }
  const bool is_fixed = directions.size() == is_held.size();
  graph.set_fixed(vertex, is_fixed);
  if (!is_fixed) graph.fix_directions(vertex, directions);
}

bool is_reprojection(const detail::EdgePool& pool) {
  bool found = false;
  detail::CameraList::for_each([&]<class Camera>() {
    const auto is = [&]<class Pool>() { return typeid(pool) == typeid(Pool); };
    using namespace detail;
    found = found || is.template operator()<TypedEdgePool<Reprojection<Camera>, SE3, Vector3, Camera>>() ||
            is.template operator()<TypedEdgePool<Reprojection<Camera>, SE3, Vector3, SE3, Camera>>() ||
            is.template operator()<TypedEdgePool<Reprojection<Camera>, Product<SE3, Camera>, Vector3>>() ||
            is.template operator()<TypedEdgePool<CalibratedReprojection<Camera>, SE3, Vector3>>();
  });
  return found;
}

}  // namespace

std::string_view to_string(BundlePart part) {
  switch (part) {
    case BundlePart::kPoses:
      return "poses";
    case BundlePart::kPoints:
      return "points";
    case BundlePart::kFocalLengths:
      return "focal-lengths";
    case BundlePart::kPrincipalPoints:
      return "principal-points";
    case BundlePart::kDistortion:
      return "distortion";
    default:
      return "intrinsics";
  }
}

std::optional<BundlePart> find_bundle_part(std::string_view name) {
  const auto* const found =
      std::find_if(kParts.begin(), kParts.end(), [&](BundlePart part) { return to_string(part) == name; });
  return found == kParts.end() ? std::nullopt : std::optional(*found);
}

std::span<const BundlePart> bundle_parts() {
  return kParts;
}

std::size_t hold(Graph& graph, BundlePart part, bool held) {
  std::size_t count = 0;
  for (const auto& vertices : {graph.all_parameters(), graph.all_vertices()}) {
    for (const VertexRef& vertex : vertices) {
      const detail::VertexPool& pool = *graph.vertex_pools()[vertex.pool];
      const bool is_offset = pool.parameter(vertex.slot) && (holds<SE3>(pool) || holds<Vector3>(pool));
      const Directions range = range_in(pool, part);
      if (is_offset || range.begin == range.end) continue;
      hold(graph, vertex, range, held);
      ++count;
    }
  }
  return count;
}

std::size_t set_pixel_sigma(Graph& graph, double sigma) {
  constexpr double kLeast = 1e-100, kLargest = 1e100;  // so that Ω neither overflows nor vanishes
  if (!(sigma >= kLeast && sigma <= kLargest))
    throw InvalidArgument(
        fmt::format("pixel sigma: expected a number from {} to {}, got {}", kLeast, kLargest, sigma));
  std::size_t count = 0;
  for (const EdgeRef& edge : graph.all_edges()) {
    if (!is_reprojection(*graph.edge_pools()[edge.pool])) continue;
    graph.set_information(edge, 1 / (sigma * sigma));
    ++count;
  }
  return count;
}

}  // namespace boxplus
