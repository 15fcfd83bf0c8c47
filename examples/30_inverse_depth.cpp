// SPDX-License-Identifier: BSD-3-Clause
// A camera sees near and far points, and stars at infinity. One view of a point gives its direction, but not
// its depth. With the inverse of the depth as an unknown, all points start from their first view, a star is
// the ordinary value 0, and the uncertainty of far points is nearly Gaussian (Civera, Davison and Montiel,
// "Inverse depth parametrization for monocular SLAM", 2008).
#include <boxplus/boxplus.h>
#include <boxplus/types/ba.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

using namespace boxplus;

constexpr double kFocalLength = 400, kWidth = 640, kHeight = 480;  // pixels
constexpr double kPixelNoise = 0.5, kOdometryNoise = 0.05, kTurnNoise = 0.01;
constexpr int kViews = 16;
constexpr std::size_t kKinds = 4, kPointsOfAKind = 60;

struct Point {
  Vector2 slopes;        ///< x/z and y/z in the frame of its anchor
  double inverse_depth;  ///< 1/z; 0 at infinity
  std::size_t anchor;    ///< the view that sees it first
};

struct Sight {
  std::size_t view;
  Vector2 pixel;
};

/// The slopes x/z and y/z of a point that its anchor measures. They say nothing of the depth.
struct Direction {
  Vector2 measurement;

  template <class P>
  auto error(const P& psi) const {
    return (psi.template head<2>() - measurement).eval();
  }
};

const StereoCamera kCamera{Vector<double, 4>(kFocalLength, kWidth / 2, kHeight / 2, 0)};

/// The poses of a camera that flies sideways and turns slowly. Its axis is z.
std::vector<SE3> simulated_poses() {
  std::vector<SE3> poses;
  for (int k = 0; k < kViews; ++k) {
    const double t = k;
    poses.emplace_back(Vector3(0.3 * t, 0.1 * std::sin(t), 0.05 * t),
                       SO3::from_rotation_vector(Vector3(0.02 * std::sin(t), 0.01 * t, 0)).quaternion());
  }
  return poses;
}

/// The views after the anchor that have the point in their image.
std::vector<Sight> simulated_sights(const Point& point, const std::vector<SE3>& poses) {
  const Vector3 psi(point.slopes[0], point.slopes[1], point.inverse_depth);
  std::vector<Sight> sights;
  for (std::size_t k = point.anchor + 1; k < poses.size(); ++k) {
    const Vector2 pixel = InverseDepthImage(Vector2(0, 0)).error(psi, poses[k], poses[point.anchor], kCamera);
    if (pixel[0] >= 0 && pixel[0] < kWidth && pixel[1] >= 0 && pixel[1] < kHeight)
      sights.push_back({k, pixel});
  }
  return sights;
}

int main() {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::normal_distribution<double> normal;
  const std::vector<SE3> truth = simulated_poses();
  // Points at 4 m, 20 m and 200 m, and at infinity, which at least three views see after their anchor.
  std::vector<Point> points;
  for (const double inverse_depth : {1 / 4.0, 1 / 20.0, 1 / 200.0, 0.0}) {
    for (std::size_t k = 0; k < kPointsOfAKind;) {
      const double x = 0.75 * uniform(random), y = 0.55 * uniform(random);
      const Point point{{x, y}, inverse_depth, k % 3 * 4};
      if (simulated_sights(point, truth).size() < 3) continue;
      points.push_back(point);
      ++k;
    }
  }

  Graph graph;
  const auto camera = graph.add_parameter(kCamera);
  // The first two poses are known, and with them the scale. The other poses start from odometry.
  std::vector<VertexHandle<SE3>> poses;
  for (std::size_t k = 0; k < truth.size(); ++k) {
    if (k < 2) {
      poses.push_back(graph.add_vertex(truth[k]));
      graph.fix(poses.back());
      continue;
    }
    Vector3 shift, turn;
    for (int i = 0; i < 3; ++i) {
      shift[i] = kOdometryNoise * normal(random);
      turn[i] = kTurnNoise * normal(random);
    }
    const SE3 motion = truth[k - 1].inverse_times(truth[k]);
    poses.push_back(graph.add_vertex(graph.estimate(poses.back()) * motion *
                                     SE3(shift, SO3::from_rotation_vector(turn).quaternion())));
  }

  const double sigma = kPixelNoise / kFocalLength;  // of a slope
  std::vector<VertexHandle<Vector3>> psi;
  for (const Point& point : points) {
    const double x = point.slopes[0] + sigma * normal(random), y = point.slopes[1] + sigma * normal(random);
    psi.push_back(graph.add_vertex(Vector3(x, y, 0.1)));  // from its first view, at a depth of 10 m
    graph.set_eliminated(psi.back(), true);
    graph.add_edge(Direction{{x, y}}, 1 / (sigma * sigma), psi.back());
    for (const auto& [view, pixel] : simulated_sights(point, truth)) {
      const double u = pixel[0] + kPixelNoise * normal(random), v = pixel[1] + kPixelNoise * normal(random);
      graph.add_edge(InverseDepthImage(Vector2(u, v)), 1 / (kPixelNoise * kPixelNoise), psi.back(),
                     poses[view], poses[point.anchor], camera);
    }
  }
  const auto worst_position = [&] {
    double worst = 0;
    for (std::size_t k = 0; k < truth.size(); ++k)
      worst = std::max(worst, (graph.estimate(poses[k]).translation() - truth[k].translation()).norm());
    return worst;
  };
  const double worst_start = worst_position();
  const Report report = optimize(graph);
  const double worst_end = worst_position();
  std::printf("%zu points in %zu views: worst position of the camera %.2f m, at the end %.3f m\n",
              points.size(), truth.size(), worst_start, worst_end);

  const Covariance certainty = marginal_covariances(graph, psi);
  double worst_ratio = 0;
  bool is_right = report.converged() && worst_end < 0.1 && std::abs(report.chi2_per_degree() - 1) < 0.1;
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    double squares = 0, variances = 0;
    const double expected = points[kind * kPointsOfAKind].inverse_depth;
    for (std::size_t k = 0; k < kPointsOfAKind; ++k) {
      const auto point = psi[kind * kPointsOfAKind + k];
      const double error = graph.estimate(point)[2] - expected, variance = certainty.of(point)(2, 2);
      squares += error * error;
      variances += variance;
      worst_ratio = std::max(worst_ratio, std::abs(error) / std::sqrt(variance));
    }
    const double rms = std::sqrt(squares / kPointsOfAKind), promised = std::sqrt(variances / kPointsOfAKind);
    std::printf("inverse depth %.3f / m: error %.4f / m (RMS), covariance promises %.4f / m\n", expected, rms,
                promised);
    is_right = is_right && rms < 0.02 * expected + 0.001;
  }
  // Of 240 normal errors, one is beyond 5 standard deviations in one of 7000 cases.
  return is_right && worst_ratio < 5 ? 0 : 1;
}
