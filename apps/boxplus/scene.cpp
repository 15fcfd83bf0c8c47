// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace boxplus::app {
namespace {

/// Where a vertex is, and whether it is a pose.
struct Place {
  Spot spot{};
  bool is_pose = false;
  std::size_t order = 0;  ///< among the poses
};

/// Seen from the front left, a little from above: a parallel projection, so that lengths stay comparable.
Spot project(const Frame& frame) {
  const auto& t = frame.translation;
  if (frame.dimension == 2) return {t[0], t[1], 0};
  constexpr double kAzimuth = -0.55, kElevation = 0.42;
  const double ca = std::cos(kAzimuth), sa = std::sin(kAzimuth), ce = std::cos(kElevation),
               se = std::sin(kElevation);
  const double right = ca * t[0] - sa * t[1], away = sa * t[0] + ca * t[1];
  return {right, ce * t[2] + se * away, se * t[2] - ce * away};
}

class SceneMaker {
 public:
  explicit SceneMaker(const Graph& graph) : graph_(graph) {}

  Scene make() {
    for (const VertexRef& vertex : graph_.all_vertices()) place(vertex);
    for (const EdgeRef& edge : graph_.all_edges()) join(edge);
    scene_.poses = poses_;
    scene_.edges = graph_.edge_count();
    scene_.chi2 = graph_.chi2();
    for (Segment& segment : scene_.segments) segment.time /= std::max<double>(1, static_cast<double>(poses_));
    enclose();
    return std::move(scene_);
  }

 private:
  void place(VertexRef vertex) {
    Frame frame;
    if (!graph_.vertex_pools()[vertex.pool]->get_frame(vertex.slot, frame)) return;
    const Spot spot = project(frame);
    if (!std::isfinite(spot[0] + spot[1] + spot[2])) return;
    scene_.is_spatial = scene_.is_spatial || frame.dimension == 3;
    places_[vertex] = {spot, frame.has_rotation, frame.has_rotation ? poses_++ : 0};
    if (!frame.has_rotation) scene_.landmarks.push_back(spot);
  }

  void join(EdgeRef edge) {
    std::vector<Place> ends;
    for (const VertexRef& vertex : graph_.vertices(edge)) {
      if (const auto found = places_.find(vertex); found != places_.end()) ends.push_back(found->second);
    }
    for (std::size_t k = 1; k < ends.size(); ++k) join(ends[0], ends[k]);
  }

  void join(const Place& a, const Place& b) {
    const std::size_t gap = std::max(a.order, b.order) - std::min(a.order, b.order);
    const SegmentKind kind = !(a.is_pose && b.is_pose) ? SegmentKind::kObservation
                             : gap == 1                ? SegmentKind::kTrajectory
                                                       : SegmentKind::kLoopClosure;
    scene_.segments.push_back({kind, a.spot, b.spot, static_cast<double>(std::max(a.order, b.order))});
  }

  void enclose() {
    scene_.low.fill(std::numeric_limits<double>::infinity());
    scene_.high.fill(-std::numeric_limits<double>::infinity());
    for (const auto& [vertex, place] : places_) {
      for (std::size_t i = 0; i < 3; ++i) {
        scene_.low[i] = std::min(scene_.low[i], place.spot[i]);
        scene_.high[i] = std::max(scene_.high[i], place.spot[i]);
      }
    }
    if (places_.empty()) scene_.low = scene_.high = {};
  }

  const Graph& graph_;
  Scene scene_;
  std::map<VertexRef, Place> places_;
  std::size_t poses_ = 0;
};

}  // namespace

Scene make_scene(const Graph& graph, std::string title) {
  Scene scene = SceneMaker(graph).make();
  scene.title = std::move(title);
  return scene;
}

}  // namespace boxplus::app
