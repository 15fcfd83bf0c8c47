// SPDX-License-Identifier: BSD-3-Clause
// Findings about connected components that can move without changing any error.
#include <fmt/format.h>

#include <algorithm>

#include "diagnose/evidence.h"
#include "diagnose/finding_table.h"
#include "diagnose/sentences.h"

namespace boxplus {
namespace {

/// The place of a component among all components.
enum class Place : std::uint8_t {
  kMain,      ///< the largest component of a graph in which nothing is anchored
  kSeparate,  ///< not anchored, and another component is
  kAnchored
};

bool only_scale(const std::vector<FreeMotions>& free) {
  return std::all_of(free.begin(), free.end(),
                     [](const FreeMotions& motions) { return motions.count == 1 && motions.scale; });
}

std::string sentence(Place place, const std::string& vertices, const char* are, const std::string& motions,
                     bool scale_only) {
  if (scale_only) {
    return fmt::format(
        "{} {} free in scale, because no edge measures a length; optimize() keeps the present scale: to "
        "choose it, fix a second pose or add a measured distance",
        vertices, are);
  }
  switch (place) {
    case Place::kMain:
      return fmt::format(
          "{} {} free {}, because nothing ties them to the world; optimize() holds one of them: to choose "
          "the place, fix a vertex or add a prior",
          vertices, are, motions);
    case Place::kSeparate:
      return fmt::format(
          "{} {} free {}, because no edge joins them to the rest of the graph: add an edge to the rest, a "
          "prior, or a fixed vertex",
          vertices, are, motions);
    default:
      return fmt::format(
          "{} {} free {}, although a prior or a fixed vertex holds them: add an edge that measures this, or "
          "fix more",
          vertices, are, motions);
  }
}

/// The vertices that the free motions of a component move, sorted by id.
std::vector<VertexRef> moved_vertices(const Evidence& evidence, const GaugeComponent& component) {
  std::vector<VertexRef> result;
  for (const VertexSlot& v : component.moved) result.push_back(evidence.vertex_ref(v.pool, v.slot));
  sort_by_id(evidence.graph, result);
  return result;
}

/// Whether the edges of each vertex alone leave it free. Then other findings say so.
bool each_is_free(const Evidence& evidence, const std::vector<VertexRef>& vertices) {
  return std::all_of(vertices.begin(), vertices.end(), [&](const VertexRef& vertex) {
    const auto index =
        static_cast<std::size_t>(evidence.find(vertex.pool, vertex.slot) - evidence.vertices.data());
    const auto found =
        std::lower_bound(evidence.free_directions.begin(), evidence.free_directions.end(), index,
                         [](const FreeDirections& free, std::size_t i) { return free.vertex < i; });
    return found != evidence.free_directions.end() && found->vertex == index;
  });
}

}  // namespace

void find_free_components(const Evidence& evidence, Findings& out) {
  const std::vector<GaugeComponent>& components = evidence.active.gauge.components;
  const bool is_anchored =
      std::any_of(components.begin(), components.end(), [](const GaugeComponent& c) { return c.anchored; });
  const auto largest = std::max_element(
      components.begin(), components.end(),
      [](const GaugeComponent& a, const GaugeComponent& b) { return a.vertices.size() < b.vertices.size(); });
  for (auto component = components.begin(); component != components.end(); ++component) {
    if (component->free.empty()) continue;
    const Place place = component->anchored                    ? Place::kAnchored
                        : !is_anchored && component == largest ? Place::kMain
                                                               : Place::kSeparate;
    const bool scale_only = only_scale(component->free);
    Finding finding;
    finding.vertices = moved_vertices(evidence, *component);
    if (finding.vertices.empty() || each_is_free(evidence, finding.vertices)) continue;
    finding.severity =
        place == Place::kMain || scale_only ? Finding::Severity::kNote : Finding::Severity::kWarning;
    std::string motions;
    for (const FreeMotions& free : component->free) {
      motions += (motions.empty() ? "" : "; ") + motions_text(free);
      append_directions(free, finding.directions);
    }
    finding.text = sentence(place, vertices_text(evidence.graph, finding.vertices),
                            by_count(finding.vertices.size(), "is", "are"), motions, scale_only);
    out.push_back(std::move(finding));
  }
}

}  // namespace boxplus
