// SPDX-License-Identifier: BSD-3-Clause
// Bundle adjustment: estimates cameras and points from the pixels at which the cameras see the points.
//
// There are many more points than cameras, and no edge connects two points. So the program marks the points
// with set_eliminated(). boxplus then eliminates the points from the linear system (by the Schur complement),
// and the remaining system contains only the unknowns of the cameras.
#include <boxplus/boxplus.h>

#include <cmath>
#include <cstdio>
#include <vector>

using namespace boxplus;

/// The pixel at which a camera sees a point. The camera looks along its z axis.
struct Pixel {
  static constexpr double kFocalLength = 500;  // pixels
  Vector2 measurement;

  template <class S, class Point>
  Vector<S, 2> error(const BasicSE3<S>& camera, const Point& point) const {
    const auto p = camera.inverse_times(point);
    return Vector<S, 2>(kFocalLength * p[0] / p[2], kFocalLength * p[1] / p[2]) - measurement;
  }
};

/// A camera on a circle around the origin. It looks at the origin.
SE3 camera_at(double angle) {
  const double half = 0.5 * (angle + kPi);
  const SE3::Quaternion turn{0, std::sin(half), 0, std::cos(half)};
  return SE3(Vector3(10 * std::sin(angle), 0, 10 * std::cos(angle)), turn);
}

int main() {
  std::vector<SE3> true_cameras;
  std::vector<Vector3> true_points;
  for (int i = 0; i < 8; ++i) true_cameras.push_back(camera_at(0.2 * i));
  for (int k = 0; k < 60; ++k)
    true_points.push_back(3 * Vector3(std::sin(1.3 * k), std::sin(2.1 * k), std::sin(3.7 * k)));

  // [eliminate]
  Graph graph;
  std::vector<VertexHandle<SE3>> cameras;
  std::vector<VertexHandle<Vector3>> points;
  for (const SE3& camera : true_cameras)
    cameras.push_back(graph.add_vertex(camera * SE3(Vector3(0.1, -0.1, 0.1), SO3())));  // a bad initial guess
  for (const Vector3& point : true_points) {
    points.push_back(graph.add_vertex(Vector3(1.1 * point)));
    graph.set_eliminated(points.back(), true);
  }
  // [/eliminate]
  for (int i : {0, 1}) {  // two known cameras determine the frame and the scale of the world
    graph.set_estimate(cameras[i], true_cameras[i]);
    graph.fix(cameras[i]);
  }
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    for (std::size_t k = 0; k < points.size(); ++k) {
      Pixel pixel{Vector2(0, 0)};
      pixel.measurement = pixel.error(true_cameras[i], true_points[k]);
      graph.add_edge(pixel, cameras[i], points[k]);
    }
  }

  const Report report = optimize(graph);
  double worst = 0;
  for (std::size_t k = 0; k < points.size(); ++k)
    worst = std::max(worst, (graph.estimate(points[k]) - true_points[k]).norm());
  std::printf("%u of %u vertices eliminated; largest error of a point: %s\n", report.eliminated,
              report.vertices, worst < 1e-6 ? "less than a micrometer" : "more than a micrometer");
  return report.converged() && report.eliminated == 60 && worst < 1e-6 ? 0 : 1;
}
