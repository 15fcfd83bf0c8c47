// SPDX-License-Identifier: BSD-3-Clause
// Findings about points that cameras see.
#include <fmt/format.h>

#include <algorithm>

#include "diagnose/camera_views.h"
#include "diagnose/evidence.h"
#include "diagnose/finding_table.h"
#include "diagnose/sentences.h"

namespace boxplus {
namespace {

const char* them(const Finding& finding) {
  return by_count(finding.vertices.size(), "it", "them");
}

/// The finding that the poses of the cameras were probably read in a wrong way.
Finding misread_poses(const CameraViews& views) {
  constexpr double kFits = 0.98;
  const auto percent = [](double share) { return 100 * share; };
  Finding finding;
  finding.severity = Finding::Severity::kWarning;
  finding.text = fmt::format(
      "{:.0f} % of the images are more than 100 standard deviations off, and the points are on both sides of "
      "their cameras, so the poses of the cameras are probably wrong: ",
      percent(static_cast<double>(views.edges_far_off) / static_cast<double>(views.edges)));
  if (views.one_sided_if_swapped >= kFits && views.one_sided_if_swapped >= views.one_sided_if_inverse) {
    finding.text += fmt::format(
        "with w at the other end of the quaternions, {:.0f} % of the points are on the same side, so check "
        "whether w comes first or last",
        percent(views.one_sided_if_swapped));
  } else if (views.one_sided_if_inverse >= kFits) {
    finding.text += fmt::format(
        "with the inverse of the poses, {:.0f} % of the points are on the same side, so check whether they "
        "are "
        "from world to camera or from camera to world",
        percent(views.one_sided_if_inverse));
  } else {
    finding.text +=
        "check whether w comes first or last in the quaternions, and whether the poses are from world to "
        "camera "
        "or from camera to world";
  }
  return finding;
}

}  // namespace

/// Cameras look along z or along −z, depending on the model. What most edges say decides.
void find_points_behind_cameras(const Evidence& evidence, Findings& out) {
  constexpr double kMost = 0.9;  // with a smaller share, the camera may see points on all sides
  for (const CameraViews& views : evidence.cameras) {
    const double share = static_cast<double>(views.edges_in_front) / static_cast<double>(views.edges);
    if (one_sided_share(views) < kMost) {
      if (2 * views.edges_far_off > views.edges) out.push_back(misread_poses(views));
      continue;
    }
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
