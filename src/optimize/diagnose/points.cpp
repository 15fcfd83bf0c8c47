// SPDX-License-Identifier: BSD-3-Clause
// Findings about points that cameras see.
#include <fmt/format.h>

#include <algorithm>

#include "optimize/diagnose/evidence.h"
#include "optimize/diagnose/finding_table.h"
#include "optimize/diagnose/sentences.h"

namespace boxplus {
namespace {

const char* them(const Finding& finding) {
  return by_count(finding.vertices.size(), "it", "them");
}

}  // namespace

/// Cameras look along z or along −z, depending on the model. What most edges say decides.
void find_points_behind_cameras(const Evidence& evidence, Findings& out) {
  constexpr double kMost = 0.9;  // with a smaller share, the camera may see points on all sides
  for (const CameraViews& views : evidence.cameras) {
    const double share = static_cast<double>(views.edges_in_front) / static_cast<double>(views.edges);
    if (share < kMost && share > 1 - kMost) continue;
    Finding finding;
    for (std::uint32_t slot = 0; slot < views.seen.size(); ++slot) {
      const std::uint32_t right =
          share >= kMost ? views.in_front[slot] : views.seen[slot] - views.in_front[slot];
      if (views.seen[slot] > 0 && right == 0)
        finding.vertices.push_back(evidence.vertex_ref(views.point_pool, slot));
    }
    if (finding.vertices.empty()) continue;
    sort_by_id(evidence.graph, finding.vertices);
    finding.severity = severity_by_share(finding.vertices.size(), views.points);
    finding.text = fmt::format(
        "{} {} behind all cameras that see {}, and a run seldom brings {} to the front: triangulate {} "
        "again, "
        "or remove {}",
        vertices_text(evidence.graph, finding.vertices), by_count(finding.vertices.size(), "is", "are"),
        them(finding), them(finding), them(finding), them(finding));
    out.push_back(std::move(finding));
  }
}

void find_far_points(const Evidence& evidence, Findings& out) {
  constexpr double kFar = 1000;  // times the median distance
  for (const CameraViews& views : evidence.cameras) {
    Finding finding;
    double farthest = 0;
    for (std::uint32_t slot = 0; slot < views.seen.size(); ++slot) {
      if (views.seen[slot] == 0 || !(views.nearest[slot] > kFar * views.median_distance)) continue;
      finding.vertices.push_back(evidence.vertex_ref(views.point_pool, slot));
      farthest = std::max(farthest, views.nearest[slot]);
    }
    if (finding.vertices.empty()) continue;
    sort_by_id(evidence.graph, finding.vertices);
    finding.severity = severity_by_share(finding.vertices.size(), views.points);
    finding.text = fmt::format(
        "{} {} up to {:.3g} times as far from the cameras as most points, so the rays are parallel and the "
        "depth is free: remove {}, or add views from farther apart",
        vertices_text(evidence.graph, finding.vertices), by_count(finding.vertices.size(), "is", "are"),
        farthest / views.median_distance, them(finding));
    out.push_back(std::move(finding));
  }
}

}  // namespace boxplus
