// SPDX-License-Identifier: BSD-3-Clause
#include "plot/ellipses.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/symmetric_eigen.h"
#include "boxplus/covariance/covariance.h"
#include "plot/colors.h"
#include "viewer/scene/uncertainty.h"

namespace boxplus::app {
namespace {

/// The 95 % quantile of the chi-squared distribution with two degrees of freedom: −2 ln 0.05.
constexpr double kChi2 = 5.991464547107979;

/// Returns the matrix that maps vectors of the world to the picture plane.
Eigen::MatrixXd to_picture(int dimension, const View& view) {
  Eigen::MatrixXd plane(2, dimension);
  for (int axis = 0; axis < dimension; ++axis) {
    std::array<double, 3> unit{};
    unit[axis] = 1;
    const Spot spot = project(unit, dimension, view);
    plane.col(axis) << spot[0], spot[1];
  }
  return plane;
}

double length(const std::array<double, 2>& v) {
  return std::hypot(v[0], v[1]);
}

/// Returns how far an ellipse extends from its center in the direction of the unit vector (x, y).
double reach(const Ellipse& ellipse, double x, double y) {
  return std::hypot(ellipse.long_axis[0] * x + ellipse.long_axis[1] * y,
                    ellipse.short_axis[0] * x + ellipse.short_axis[1] * y);
}

bool lies_over(const Ellipse& a, const Ellipse& b, double gap) {
  // As a fraction of the distance at which the ellipses touch. Ellipses that overlap a little are legible.
  constexpr double kPart = 0.9;
  if (a.is_pose != b.is_pose) return false;
  const double dx = b.center[0] - a.center[0], dy = b.center[1] - a.center[1], distance = std::hypot(dx, dy);
  if (distance <= gap) return true;
  const double x = dx / distance, y = dy / distance;
  return distance < kPart * (reach(a, x, y) + reach(b, x, y));
}

std::vector<Ellipse> ellipses_of(const Graph& graph, const View& view, const std::string& name) {
  const std::vector<VertexRef> vertices = graph.all_vertices();
  const Covariance covariance = marginal_covariances(graph, vertices);
  if (!covariance.ok()) throw InvalidArgument(name + ": " + covariance.message());
  std::vector<Ellipse> ellipses;
  std::size_t poses = 0;
  for (const VertexRef& vertex : vertices) {
    detail::Frame frame;
    if (!graph.vertex_pools()[vertex.pool]->get_frame(vertex.slot, frame)) continue;
    ellipses.push_back(ellipse_of(frame, viewer::position_covariance(graph, vertex, covariance), view,
                                  static_cast<double>(poses)));
    poses += frame.has_rotation;
  }
  for (Ellipse& ellipse : ellipses) ellipse.time /= static_cast<double>(std::max<std::size_t>(2, poses) - 1);
  return ellipses;
}

}  // namespace

Ellipse ellipse_of(const detail::Frame& frame, const Eigen::MatrixXd& covariance, const View& view,
                   double time) {
  const Eigen::MatrixXd P = to_picture(frame.dimension, view);
  const SymmetricEigen axes = symmetric_eigen(P * covariance * P.transpose());
  const auto half_axis = [&](int k) {
    const Eigen::Vector2d v = std::sqrt(kChi2 * std::max(0.0, axes.values[k])) * axes.vectors.col(k);
    return std::array{v[0], v[1]};
  };
  return {project(frame.translation, frame.dimension, view), half_axis(1), half_axis(0), frame.has_rotation,
          time};
}

std::vector<Ellipse> legible(const std::vector<Ellipse>& ellipses, double pixel) {
  constexpr double kLeast = 1.5, kGap = 10;  // in pixels
  constexpr std::size_t kMost = 300;
  std::vector<Ellipse> kept;
  for (auto ellipse = ellipses.rbegin(); ellipse != ellipses.rend() && kept.size() < kMost; ++ellipse) {
    if (!(length(ellipse->long_axis) >= kLeast * pixel)) continue;
    const auto is_over = [&](const Ellipse& other) { return lies_over(*ellipse, other, kGap * pixel); };
    if (std::none_of(kept.begin(), kept.end(), is_over)) kept.push_back(*ellipse);
  }
  return kept;
}

void enclose_ellipses(Scene& scene) {
  // The space for ellipses on each side, as a fraction of the size of the scene.
  constexpr double kMost = 0.25;
  const double room = kMost * std::max(scene.high[0] - scene.low[0], scene.high[1] - scene.low[1]);
  const Spot low = scene.low, high = scene.high;
  for (const Ellipse& ellipse : scene.ellipses) {
    for (std::size_t axis : {0, 1}) {
      const double extent = axis == 0 ? reach(ellipse, 1, 0) : reach(ellipse, 0, 1);
      scene.low[axis] = std::min(scene.low[axis], std::max(ellipse.center[axis] - extent, low[axis] - room));
      scene.high[axis] =
          std::max(scene.high[axis], std::min(ellipse.center[axis] + extent, high[axis] + room));
    }
  }
}

void add_ellipses(Scene& scene, const Graph& graph, const View& view, const std::string& name) {
  scene.has_ellipses = true;
  scene.ellipses = ellipses_of(graph, view, name);
  enclose_ellipses(scene);
}

void draw_ellipses(const std::vector<Ellipse>& ellipses, const PlaneMap& map, const Box& box, double width,
                   Canvas& canvas) {
  constexpr int kCorners = 48;
  const auto is_inside = [&](Point p) {
    return p.x >= box.left && p.x <= box.right() && p.y >= box.top && p.y <= box.bottom();
  };
  for (const Ellipse& ellipse : ellipses) {
    Path path;
    bool goes_on = false;
    for (int corner = 0; corner <= kCorners; ++corner) {
      const double angle = 2 * std::numbers::pi * corner / kCorners, c = std::cos(angle), s = std::sin(angle);
      const Point point = map(ellipse.center[0] + c * ellipse.long_axis[0] + s * ellipse.short_axis[0],
                              ellipse.center[1] + c * ellipse.long_axis[1] + s * ellipse.short_axis[1]);
      const bool is_next = goes_on;
      goes_on = is_inside(point);
      if (!goes_on) continue;
      is_next ? path.line_to(point) : path.move_to(point);
    }
    if (!path.empty())
      canvas.stroke(path, {ellipse.is_pose ? trajectory_color(ellipse.time) : kLandmarkColor, width, 0.9});
  }
}

}  // namespace boxplus::app
