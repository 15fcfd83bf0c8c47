// SPDX-License-Identifier: BSD-3-Clause
#include "diagnose/sentences.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace boxplus {
namespace {

enum class Noun : std::uint8_t { kPose, kPoint, kParameter, kVertex };

Noun noun_of(const Graph& graph, VertexRef vertex) {
  const detail::VertexPool& pool = *graph.vertex_pools()[vertex.pool];
  if (pool.parameter(vertex.slot)) return Noun::kParameter;
  detail::Frame frame;
  if (!pool.get_frame(vertex.slot, frame)) return Noun::kVertex;
  return frame.has_rotation ? Noun::kPose : Noun::kPoint;
}

/// All vertices of a pool have one type.
const char* noun_text(const Graph& graph, std::span<const VertexRef> vertices) {
  constexpr const char* kSingular[] = {"pose", "point", "parameter", "vertex"};
  constexpr const char* kPlural[] = {"poses", "points", "parameters", "vertices"};
  Noun noun = noun_of(graph, vertices.front());
  std::uint32_t last = vertices.front().pool;
  for (const VertexRef& vertex : vertices) {
    if (vertex.pool == last) continue;
    last = vertex.pool;
    if (noun_of(graph, vertex) != noun) noun = Noun::kVertex;
  }
  return by_count(vertices.size(), kSingular[static_cast<int>(noun)], kPlural[static_cast<int>(noun)]);
}

std::string ids_text(const std::vector<Id>& ids) {
  constexpr std::size_t kMost = 6;
  const bool in_a_row = static_cast<std::uint64_t>(ids.back() - ids.front()) == ids.size() - 1;
  if (ids.size() > 2 && in_a_row) return fmt::format("{}…{}", ids.front(), ids.back());
  if (ids.size() <= kMost) return fmt::format("{}", fmt::join(ids, ", "));
  return fmt::format("{}, … ({} in all)", fmt::join(ids.begin(), ids.begin() + (kMost - 1), ", "),
                     ids.size());
}

std::string short_edge_text(const Graph& graph, EdgeRef edge) {
  std::vector<Id> ids;
  for (const VertexRef& vertex : graph.vertices(edge)) {
    if (!graph.vertex_pools()[vertex.pool]->parameter(vertex.slot)) ids.push_back(graph.id(vertex));
  }
  const std::string_view type = graph.edge_pools()[edge.pool]->type_name();
  if (ids.empty()) return std::string(type);
  constexpr std::size_t kMost = 6;
  const std::size_t shown = std::min(kMost, ids.size());
  return fmt::format("{} of {} {}{}", type, by_count(ids.size(), "vertex", "vertices"),
                     fmt::join(ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(shown), ", "),
                     ids.size() > kMost ? ", …" : "");
}

/// A number without trailing noise: 0.6, −1, 0.
double tidy(double value) {
  const double rounded = std::round(1000 * value) / 1000;
  return rounded == 0 ? 0 : rounded;
}

std::string vector_text(std::span<const double> values) {
  std::vector<double> shown;
  for (const double value : values) shown.push_back(tidy(value));
  return fmt::format("({})", fmt::join(shown, ", "));
}

std::string list_text(const std::vector<std::string>& words) {
  if (words.size() == 1) return words.front();
  return fmt::format("{} and {}", fmt::join(words.begin(), words.end() - 1, ", "), words.back());
}

/// The coordinate axis that a unit vector is parallel to, or −1.
int axis_of(std::span<const double> values) {
  constexpr double kZero = 1e-6;
  int axis = -1;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::abs(values[i]) > 1 - kZero) axis = static_cast<int>(i);
  }
  return axis;
}

constexpr const char* kPositions[] = {"x", "y", "z"};
constexpr const char* kRotations[] = {"roll", "pitch", "yaw"};

}  // namespace

std::string vertices_text(const Graph& graph, std::span<const VertexRef> vertices) {
  std::vector<Id> ids;
  ids.reserve(vertices.size());
  for (const VertexRef& vertex : vertices) ids.push_back(graph.vertex_pools()[vertex.pool]->id(vertex.slot));
  return fmt::format("{} {}", noun_text(graph, vertices), ids_text(ids));
}

std::string edges_text(const Graph& graph, std::span<const EdgeRef> edges) {
  if (edges.size() == 1) return "the edge " + short_edge_text(graph, edges.front());
  return fmt::format("{} edges, such as {}", edges.size(), short_edge_text(graph, edges.front()));
}

std::string motions_text(const FreeMotions& motions) {
  std::vector<std::string> named, others;
  const auto add = [&](const FreeMotions::Axis& axis, const char* const* names, const char* preposition) {
    const int known = axis_of(axis);
    if (known >= 0) {
      named.emplace_back(names[known]);
    } else {
      others.push_back(preposition + vector_text(axis));
    }
  };
  for (const FreeMotions::Axis& axis : motions.along) add(axis, kPositions, "along ");
  for (const FreeMotions::Axis& axis : motions.about) add(axis, kRotations, "about ");
  if (motions.scale) named.emplace_back("scale");
  std::string text = named.empty() ? "" : "in " + list_text(named);
  if (!others.empty()) text += (text.empty() ? "" : " and ") + list_text(others);
  return text;
}

std::string direction_text(const Graph& graph, VertexRef vertex, std::span<const double> tangent) {
  const int axis = axis_of(tangent);
  if (axis < 0) return vector_text(tangent);
  detail::Frame frame;
  if (graph.vertex_pools()[vertex.pool]->get_frame(vertex.slot, frame)) {
    if (axis < frame.dimension) return kPositions[axis];
    const int rotation = axis - frame.dimension;
    if (frame.has_rotation && frame.dimension == 2 && rotation == 0) return "yaw";
    if (frame.has_rotation && frame.dimension == 3 && rotation < 3) return kRotations[rotation];
  }
  return fmt::format("direction {}", axis);
}

void sort_by_id(const Graph& graph, std::vector<VertexRef>& vertices) {
  std::vector<std::tuple<bool, Id, VertexRef>> ranked;  // parameters have ids of their own, and come last
  ranked.reserve(vertices.size());
  for (const VertexRef& vertex : vertices) {
    const detail::VertexPool& pool = *graph.vertex_pools()[vertex.pool];
    ranked.emplace_back(pool.parameter(vertex.slot), pool.id(vertex.slot), vertex);
  }
  if (std::is_sorted(ranked.begin(), ranked.end())) return;
  std::sort(ranked.begin(), ranked.end());
  std::transform(ranked.begin(), ranked.end(), vertices.begin(),
                 [](const auto& r) { return std::get<2>(r); });
}

void append_directions(const FreeMotions& motions, std::vector<Finding::Direction>& out) {
  using Kind = Finding::Direction::Kind;
  for (const FreeMotions::Axis& axis : motions.along) out.push_back({.kind = Kind::kAlong, .axis = axis});
  for (const FreeMotions::Axis& axis : motions.about) out.push_back({.kind = Kind::kAbout, .axis = axis});
  if (motions.scale) out.push_back({.kind = Kind::kScale});
}

}  // namespace boxplus
