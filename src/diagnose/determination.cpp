// SPDX-License-Identifier: BSD-3-Clause
// Findings about vertices whose own edges do not determine them, wherever all other vertices are.
#include <fmt/format.h>

#include <map>

#include "diagnose/evidence.h"
#include "diagnose/finding_table.h"
#include "diagnose/sentences.h"

namespace boxplus {
namespace {

/// The reason why a direction is free.
enum class Cause : std::uint8_t { kZeroJacobian, kSeenOnce, kOther };

Cause cause_of(const Evidence& evidence, const FreeDirections& free) {
  const VertexEvidence& vertex = evidence.vertices[free.vertex];
  const detail::VertexPool& pool = *evidence.graph.vertex_pools()[vertex.vertex.pool];
  const std::size_t moving =
      static_cast<std::size_t>(vertex.dim) - pool.fixed_directions(vertex.vertex.slot).size();
  if (free.directions.size() == moving) return Cause::kZeroJacobian;
  detail::Frame frame;
  const bool is_point = pool.get_frame(vertex.vertex.slot, frame) && !frame.has_rotation;
  return is_point && vertex.edges == 1 ? Cause::kSeenOnce : Cause::kOther;
}

void add_directions(const Evidence& evidence, const FreeDirections& free, Finding& finding) {
  const VertexRef vertex = evidence.vertices[free.vertex].vertex;
  finding.vertices.push_back(vertex);
  for (const std::vector<double>& direction : free.directions) {
    finding.directions.push_back(
        {.kind = Finding::Direction::Kind::kTangent, .vertex = vertex, .tangent = direction});
  }
}

template <class F>
void for_each_with(const Evidence& evidence, Cause cause, F&& f) {
  for (const FreeDirections& free : evidence.free_directions) {
    if (cause_of(evidence, free) == cause) f(free);
  }
}

std::string directions_text(const Evidence& evidence, const FreeDirections& free) {
  std::string text;
  for (const std::vector<double>& direction : free.directions) {
    text += text.empty() ? "" : ", ";
    text += direction_text(evidence.graph, evidence.vertices[free.vertex].vertex, direction);
  }
  return text;
}

/// A few points among many do not spoil the rest, but a pose may.
Finding::Severity severity_of(const Evidence& evidence, const Finding& finding) {
  std::size_t alike = 0;
  const std::uint32_t first = finding.vertices.front().pool;
  for (const VertexEvidence& vertex : evidence.vertices) alike += vertex.vertex.pool == first;
  for (const VertexRef& vertex : finding.vertices) {
    detail::Frame frame;
    const bool has_frame = evidence.graph.vertex_pools()[vertex.pool]->get_frame(vertex.slot, frame);
    if (!has_frame || frame.has_rotation || vertex.pool != first) return Finding::Severity::kWarning;
  }
  return severity_by_share(finding.vertices.size(), alike);
}

}  // namespace

void find_zero_jacobians(const Evidence& evidence, Findings& out) {
  Finding finding;
  for_each_with(evidence, Cause::kZeroJacobian,
                [&](const FreeDirections& free) { add_directions(evidence, free, finding); });
  if (finding.vertices.empty()) return;
  sort_by_id(evidence.graph, finding.vertices);
  finding.severity = Finding::Severity::kWarning;
  finding.text = fmt::format(
      "no edge of {} changes if {} moves: all Jacobians are zero, or their Ω is; start from other estimates, "
      "or check the error function",
      vertices_text(evidence.graph, finding.vertices),
      by_count(finding.vertices.size(), "it", "one of them"));
  out.push_back(std::move(finding));
}

/// One finding per combination of axes. Directions that are no axes are one finding.
void find_undetermined_directions(const Evidence& evidence, Findings& out) {
  std::map<std::string, Finding> by_words;
  std::map<std::string, std::string> example;
  for_each_with(evidence, Cause::kOther, [&](const FreeDirections& free) {
    const std::string words = directions_text(evidence, free);
    const std::string key = words.find('(') == std::string::npos ? words : "";
    example.try_emplace(key, words);
    add_directions(evidence, free, by_words[key]);
  });
  for (auto& [key, finding] : by_words) {
    const VertexRef first = finding.vertices.front();
    sort_by_id(evidence.graph, finding.vertices);
    finding.severity = severity_of(evidence, finding);
    const std::string such =
        key.empty() && finding.vertices.size() > 1
            ? fmt::format(" (this is the direction of vertex {})", evidence.graph.id(first))
            : "";
    finding.text = fmt::format(
        "the edges of {} do not determine {}{}: add an edge that measures it, or fix it "
        "(Graph::fix_directions())",
        vertices_text(evidence.graph, finding.vertices), example[key], such);
    out.push_back(std::move(finding));
  }
}

void find_points_seen_once(const Evidence& evidence, Findings& out) {
  Finding finding;
  for_each_with(evidence, Cause::kSeenOnce, [&](const FreeDirections& free) {
    add_directions(evidence, free, finding);
    const VertexEvidence& vertex = evidence.vertices[free.vertex];
    finding.edges.push_back(evidence.edge_ref(vertex.last_pool, vertex.last));
  });
  if (finding.vertices.empty()) return;
  sort_by_id(evidence.graph, finding.vertices);
  finding.severity = severity_of(evidence, finding);
  finding.text = fmt::format(
      "{} {} seen only once, so {} depth is free: remove {}, or add a second observation from another place",
      vertices_text(evidence.graph, finding.vertices), by_count(finding.vertices.size(), "is", "are"),
      by_count(finding.vertices.size(), "its", "their"), by_count(finding.vertices.size(), "it", "them"));
  out.push_back(std::move(finding));
}

}  // namespace boxplus
