// SPDX-License-Identifier: BSD-3-Clause
// Fixes some directions of the tangent space of a vertex. The first example has 3-D poses of a vehicle that
// stays on a plane. The second example has the intrinsics of a camera with a known focal length and an
// unknown distortion.
#include <boxplus/boxplus.h>

#include <cmath>
#include <cstdio>
#include <vector>

using namespace boxplus;

/// The measured distance (pixels) between the center of the image and the image of a ray. The model for a ray
/// with slope r is f (1 + k r²) r, with the focal length f and the distortion k.
struct Ray {
  double ray, pixels;

  template <class S>
  S error(const Vector<S, 2>& focal_length_and_distortion) const {
    const auto& [f, k] = std::pair(focal_length_and_distortion[0], focal_length_and_distortion[1]);
    return f * (1.0 + k * ray * ray) * ray - pixels;
  }
};

SE3 on_the_plane(double x, double y, double heading) {
  return SE3(Vector3(x, y, 0.7), SE3::Quaternion{0, 0, std::sin(heading / 2), std::cos(heading / 2)});
}

int main() {
  // [plane]
  Graph graph;
  std::vector<VertexHandle<SE3>> poses;
  for (int k = 0; k < 8; ++k) {
    poses.push_back(graph.add_vertex(on_the_plane(k, 0.1 * k, 0.05 * k)));
    graph.fix_directions(poses.back(), {2, 3, 4});  // z, roll and pitch of (Δt, Δq)
  }
  // [/plane]
  graph.fix(poses[0]);
  // According to the sensor, the vehicle climbs and tilts a little.
  const SE3 tilted(Vector3(1, 0, 0.05), SE3::Quaternion{0.01, -0.02, 0.03, 1});
  for (std::size_t k = 0; k + 1 < poses.size(); ++k) graph.add_edge(Between(tilted), poses[k], poses[k + 1]);
  const Report report = optimize(graph);
  const auto last = graph.estimate(poses.back()).vector();
  std::printf("%u unknowns; the last pose is at %.3f, %.3f, %.3f, with roll and pitch %g, %g\n",
              report.scalars, last[0], last[1], last[2], last[3], last[4]);

  // [focal_length]
  const auto intrinsics = graph.add_vertex(Vector2(500, 0));  // focal length, distortion
  graph.fix_directions(intrinsics, {0});
  // [/focal_length]
  for (const double ray : {-0.8, -0.4, 0.2, 0.7})
    graph.add_edge(Ray{ray, 500 * (1 - 0.1 * ray * ray) * ray}, intrinsics);
  const bool is_calibrated = optimize(graph).converged();
  std::printf("focal length %g, distortion %.3f\n", graph.estimate(intrinsics)[0],
              graph.estimate(intrinsics)[1]);
  const bool is_right = is_calibrated && last[2] == 0.7 && last[3] == 0 && last[4] == 0 &&
                        graph.estimate(intrinsics)[0] == 500 &&
                        std::abs(graph.estimate(intrinsics)[1] + 0.1) < 1e-9;
  return report.status == Report::Status::kConverged && is_right ? 0 : 1;
}
