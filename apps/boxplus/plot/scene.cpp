// SPDX-License-Identifier: BSD-3-Clause
#include "plot/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "graph/graph_view.h"

namespace boxplus::app {
namespace {

/// The position of a vertex (if it is known), and whether the vertex is a pose.
struct Place {
  Spot spot{};
  bool is_known = false, is_pose = false;
  std::size_t order = 0;  ///< the position of a pose in the list of poses sorted by id
  Id id = 0;
};

bool is_near(const Spot& spot) {
  constexpr double kFarthest = 1e100;  // small enough that no sum or square of lengths overflows
  return std::abs(spot[0]) + std::abs(spot[1]) + std::abs(spot[2]) < kFarthest;
}

class SceneMaker {
 public:
  SceneMaker(const Graph& graph, const View& view, const TruePlaces& truth)
      : graph_(graph), role_(graph), view_(view), truth_(truth) {}

  Scene make() {
    for (const auto& pool : graph_.vertex_pools()) places_.emplace_back(pool->slots());
    for (const VertexRef& vertex : graph_.all_vertices()) place(vertex);
    for (const EdgeRef& edge : graph_.all_edges()) join(edge);
    scene_.poses = poses_.size();
    scene_.landmark_count = scene_.landmarks.size();
    scene_.edges = graph_.edge_count();
    scene_.chi2 = graph_.chi2();
    std::stable_sort(scene_.segments.begin(), scene_.segments.end(),
                     [](const Segment& a, const Segment& b) { return a.time < b.time; });
    add_dots();
    enclose();
    return std::move(scene_);
  }

 private:
  Place& place_of(VertexRef vertex) { return places_[vertex.pool][vertex.slot]; }

  void place(VertexRef vertex) {
    detail::Frame frame;
    if (!graph_.vertex_pools()[vertex.pool]->get_frame(vertex.slot, frame)) return;
    const Spot spot = project(frame.translation, frame.dimension, view_);
    if (!is_near(spot)) {
      ++scene_.hidden;
      return;
    }
    scene_.is_spatial = scene_.is_spatial || frame.dimension == 3;
    place_of(vertex) = {spot, true, frame.has_rotation, poses_.size(), graph_.id(vertex)};
    if (frame.has_rotation) {
      poses_.push_back({spot, false});
    } else {
      scene_.landmarks.push_back(spot);
    }
  }

  void join(EdgeRef edge) {
    const RobustKernel* kernel = graph_.kernel(edge);
    if (kernel && scene_.kernel.empty()) scene_.kernel = kernel->name();
    const double chi2 = graph_.chi2(edge), robust_chi2 = kernel ? (*kernel)(chi2).value : chi2;
    const double chi2_per_row = robust_chi2 / std::max(1, graph_.information(edge).rows);
    const EdgeRole role = role_(edge);
    const SegmentKind kind = role == EdgeRole::kOdometry      ? SegmentKind::kTrajectory
                             : role == EdgeRole::kLoopClosure ? SegmentKind::kLoopClosure
                                                              : SegmentKind::kObservation;
    const Place* first = nullptr;
    for (const VertexRef& vertex : graph_.vertices(edge)) {
      const Place& place = place_of(vertex);
      if (!place.is_known) continue;
      if (first) join(*first, place, kind, chi2_per_row);
      if (!first) first = &place;
    }
  }

  void join(const Place& a, const Place& b, SegmentKind kind, double chi2_per_row) {
    const std::size_t later = std::max(a.order, b.order);
    if (kind == SegmentKind::kTrajectory && a.is_pose && b.is_pose) {
      poses_[a.order].is_passed = poses_[b.order].is_passed = true;
      join_truth(a, b, time(later));
    }
    scene_.segments.push_back({kind, a.spot, b.spot, time(later), chi2_per_row});
  }

  void join_truth(const Place& a, const Place& b, double time) {
    const auto from = truth_.find(a.id), to = truth_.find(b.id);
    if (from == truth_.end() || to == truth_.end()) return;
    const int dimension = scene_.is_spatial ? 3 : 2;
    scene_.segments.push_back({SegmentKind::kTruth, project(from->second, dimension, view_),
                               project(to->second, dimension, view_), time, 0});
  }

  double time(std::size_t order) const {
    return static_cast<double>(order) / static_cast<double>(std::max<std::size_t>(2, poses_.size()) - 1);
  }

  void add_dots() {
    constexpr std::size_t kFew = 60;
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      if (poses_.size() <= kFew || !poses_[i].is_passed) scene_.dots.push_back({poses_[i].spot, time(i)});
    }
  }

  void enclose() {
    scene_.low.fill(std::numeric_limits<double>::infinity());
    scene_.high.fill(-std::numeric_limits<double>::infinity());
    const auto include = [&](const Spot& spot) {
      for (std::size_t i = 0; i < 3; ++i) {
        scene_.low[i] = std::min(scene_.low[i], spot[i]);
        scene_.high[i] = std::max(scene_.high[i], spot[i]);
      }
    };
    for (const Pose& pose : poses_) include(pose.spot);
    for (const Spot& landmark : scene_.landmarks) include(landmark);
    for (const Segment& segment : scene_.segments) {
      if (segment.kind != SegmentKind::kTruth) continue;
      include(segment.from);
      include(segment.to);
    }
    if (poses_.empty() && scene_.landmarks.empty()) scene_.low = scene_.high = {};
  }

  struct Pose {
    Spot spot;
    bool is_passed;
  };

  const Graph& graph_;
  EdgeRoles role_;
  const View& view_;
  const TruePlaces& truth_;
  Scene scene_;
  std::vector<std::vector<Place>> places_;  // indexed by pool and slot
  std::vector<Pose> poses_;                 // in the order of ids
};

}  // namespace

bool Scene::has(SegmentKind kind) const {
  return std::any_of(segments.begin(), segments.end(), [&](const Segment& s) { return s.kind == kind; });
}

Spot project(const std::array<double, 3>& point, int dimension, const View& view) {
  if (dimension == 2) return {point[0], point[1], 0};
  constexpr double kDegree = std::numbers::pi / 180;
  const double azimuth = kDegree * view.azimuth_deg, elevation = kDegree * view.elevation_deg;
  const double ca = std::cos(azimuth), sa = std::sin(azimuth), ce = std::cos(elevation),
               se = std::sin(elevation);
  const auto level = [&](std::size_t row) {
    const double* r = view.leveling.data() + 3 * row;
    return r[0] * point[0] + r[1] * point[1] + r[2] * point[2];
  };
  const double x = level(0), y = level(1), z = level(2);
  const double right = ca * x - sa * y, away = sa * x + ca * y;
  return {right, ce * z + se * away, se * z - ce * away};
}

Scene make_scene(const Graph& graph, std::string title, const View& view, const TruePlaces& truth) {
  Scene scene = SceneMaker(graph, view, truth).make();
  scene.title = std::move(title);
  return scene;
}

}  // namespace boxplus::app
