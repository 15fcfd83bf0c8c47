// SPDX-License-Identifier: BSD-3-Clause
#include "plot/bundle_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/ply/camera_pyramids.h"

namespace boxplus::app {
namespace {

using Position = std::array<double, 3>;

bool is_near(const Position& p) {
  constexpr double kFarthest = 1e100;  // small enough that no sum or square of lengths overflows
  return std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]) < kFarthest;
}

/// Returns the interval of most values: the middle 90 %, and a third of its length on each side, as far as
/// there are values.
std::array<double, 2> most_of(std::vector<double> values) {
  if (values.empty())
    return {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  std::sort(values.begin(), values.end());
  constexpr double kTail = 0.05, kRoom = 1.0 / 3;
  const auto last = static_cast<double>(values.size() - 1);
  const double low = values[kTail * last], high = values[std::ceil((1 - kTail) * last)],
               room = kRoom * (high - low);
  return {std::max(values.front(), low - room), std::min(values.back(), high + room)};
}

class BundleSceneMaker {
 public:
  BundleSceneMaker(const Graph& graph, const View& view, const TruePlaces& truth)
      : graph_(graph), view_(view), truth_(truth), directions_(view_directions(graph)) {}

  Scene make() {
    for (const auto& pool : graph_.vertex_pools()) sums_.emplace_back(pool->slots());
    for (const EdgeRef& edge : graph_.all_edges()) add_error(edge);
    for (const VertexRef& vertex : graph_.all_vertices()) sort(vertex);
    scene_.is_bundle = scene_.is_spatial = true;
    scene_.poses = cameras_.size();
    scene_.landmark_count = scene_.points.size();
    scene_.edges = graph_.edge_count();
    scene_.chi2 = graph_.chi2();
    enclose();
    add_cameras();
    return std::move(scene_);
  }

 private:
  struct Sum {
    double chi2 = 0, rows = 0;
  };
  struct Camera {
    detail::Frame frame;
    int direction;
    Id id;
  };

  void add_error(EdgeRef edge) {
    const RobustKernel* kernel = graph_.kernel(edge);
    if (kernel && scene_.kernel.empty()) scene_.kernel = kernel->name();
    const double chi2 = graph_.chi2(edge);
    for (const VertexRef& vertex : graph_.vertices(edge)) {
      Sum& sum = sums_[vertex.pool][vertex.slot];
      sum.chi2 += kernel ? (*kernel)(chi2).value : chi2;
      sum.rows += graph_.information(edge).rows;
    }
  }

  void sort(VertexRef vertex) {
    detail::Frame frame;
    if (!graph_.vertex_pools()[vertex.pool]->get_frame(vertex.slot, frame)) return;
    if (!is_near(frame.translation)) {
      ++scene_.hidden;
    } else if (frame.has_rotation) {
      cameras_.push_back({frame, directions_[vertex.pool], graph_.id(vertex)});
    } else {
      const Sum& sum = sums_[vertex.pool][vertex.slot];
      scene_.points.push_back({project(frame.translation, 3, view_), sum.chi2 / std::max(1.0, sum.rows)});
      positions_.push_back(frame.translation);
    }
  }

  /// Finds the box around most points and around the cameras near them, and removes the points outside.
  void enclose() {
    std::vector<Spot> centers;
    for (const Camera& camera : cameras_) centers.push_back(project(camera.frame.translation, 3, view_));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto limits_of = [axis](const auto& items, auto&& spot) {
        std::vector<double> values;
        for (const auto& item : items) values.push_back(spot(item)[axis]);
        return most_of(std::move(values));
      };
      const auto points = limits_of(scene_.points, [](const SeenPoint& point) { return point.spot; });
      const auto cameras = limits_of(centers, [](const Spot& spot) { return spot; });
      scene_.low[axis] = std::min(points[0], cameras[0]);
      scene_.high[axis] = std::max(points[1], cameras[1]);
    }
    if (scene_.points.empty() && cameras_.empty()) scene_.low = scene_.high = {};
    const auto is_outside = [&](const SeenPoint& point) {
      const Spot& spot = point.spot;
      return spot[0] < scene_.low[0] || spot[0] > scene_.high[0] || spot[1] < scene_.low[1] ||
             spot[1] > scene_.high[1];
    };
    scene_.outside = std::erase_if(scene_.points, is_outside);
  }

  void add_cameras() {
    std::vector<Position> centers;
    for (const Camera& camera : cameras_) centers.push_back(camera.frame.translation);
    const double height = pyramid_height(centers, positions_);
    const auto last = static_cast<double>(std::max<std::size_t>(2, cameras_.size()) - 1);
    for (std::size_t i = 0; i < cameras_.size(); ++i) {
      CameraMark mark;
      const PyramidCorners corners = pyramid(cameras_[i].frame, cameras_[i].direction, height);
      for (std::size_t k = 0; k < corners.size(); ++k) mark.corners[k] = project(corners[k], 3, view_);
      mark.time = static_cast<double>(i) / last;
      scene_.cameras.push_back(mark);
      const auto place = truth_.find(cameras_[i].id);
      if (place != truth_.end())
        scene_.segments.push_back(
            {SegmentKind::kTruth, mark.corners[0], project(place->second, 3, view_), mark.time, 0});
    }
  }

  const Graph& graph_;
  const View& view_;
  const TruePlaces& truth_;
  std::vector<int> directions_;         // by vertex pool
  std::vector<std::vector<Sum>> sums_;  // by vertex pool and slot
  std::vector<Camera> cameras_;         // in the order of ids
  std::vector<Position> positions_;     // of the points
  Scene scene_;
};

}  // namespace

Scene make_bundle_scene(const Graph& graph, std::string title, const View& view, const TruePlaces& truth) {
  Scene scene = BundleSceneMaker(graph, view, truth).make();
  scene.title = std::move(title);
  return scene;
}

}  // namespace boxplus::app
