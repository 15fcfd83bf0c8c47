// SPDX-License-Identifier: BSD-3-Clause
// Registers two scans of a rough ground by generalized ICP. No point of the second scan is a point of the
// first, so a match determines the distance from the surface well, and the place on the surface hardly. The
// normals of the surface come from the neighbors of each point.
#include <boxplus/boxplus.h>
#include <boxplus/types/slam3d/surface_match.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

using namespace boxplus;

constexpr double kSigma = 0.005;      // noise of each coordinate, in m
constexpr double kMatchLimit2 = 0.3;  // points that are further apart (m², squared) do not match
const SE3 kFirst(Vector3(0, 0, 2), SO3::from_rotation_vector(Vector3(0.1, 0, 0)).quaternion());
const SE3 kMotion(Vector3(0.4, -0.25, 0.1),
                  SO3::from_rotation_vector(Vector3(0.05, -0.08, 0.15)).quaternion());

struct Scan {
  std::vector<Vector3> points, normals;  // in the frame of the scanner
};

/// The height of the ground (m).
double height(double x, double y) {
  return 0.4 * std::sin(1.1 * x) + 0.3 * std::cos(1.4 * y + 0.5 * x) + 0.1 * std::sin(3 * x - 2 * y);
}

std::size_t nearest(const std::vector<Vector3>& points, const Vector3& p) {
  const auto closer = [&](const Vector3& a, const Vector3& b) {
    return (a - p).squaredNorm() < (b - p).squaredNorm();
  };
  return static_cast<std::size_t>(std::min_element(points.begin(), points.end(), closer) - points.begin());
}

/// The direction in which the point and its 11 nearest neighbors extend least.
Vector3 normal_at(std::vector<Vector3> points, const Vector3& p) {
  const auto closer = [&](const Vector3& a, const Vector3& b) {
    return (a - p).squaredNorm() < (b - p).squaredNorm();
  };
  std::nth_element(points.begin(), points.begin() + 11, points.end(), closer);
  points.resize(12);
  Vector3 mean = Vector3::Zero();
  for (const Vector3& q : points) mean += q / 12;
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Vector3& q : points) scatter += (q - mean) * (q - mean).transpose();
  return Vector3(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(0));
}

/// 900 random points of the ground, seen by a scanner at this pose.
Scan scan(const SE3& pose, std::mt19937& random) {
  std::uniform_real_distribution<double> place(-3, 3);
  std::normal_distribution<double> noise(0, kSigma);
  Scan result;
  for (int k = 0; k < 900; ++k) {
    const double x = place(random), y = place(random);
    Vector3 seen = pose.inverse_times(Vector3(x, y, height(x, y)));
    for (int i = 0; i < 3; ++i) seen[i] += noise(random);
    result.points.push_back(seen);
  }
  for (const Vector3& p : result.points) result.normals.push_back(normal_at(result.points, p));
  return result;
}

int main() {
  std::mt19937 random(2);
  const Scan first = scan(kFirst, random), second = scan(kFirst * kMotion, random);

  SE3 motion;  // of the scanner between the scans; nothing is known of it
  int rounds = 0;
  for (bool moves = true; moves && rounds < 30; ++rounds) {
    Graph graph;
    const auto x0 = graph.add_vertex(SE3()), x1 = graph.add_vertex(motion);
    graph.fix(x0);
    for (std::size_t k = 0; k < second.points.size(); ++k) {
      const Vector3 p = motion * second.points[k];
      const std::size_t match = nearest(first.points, p);
      if ((first.points[match] - p).squaredNorm() > kMatchLimit2) continue;
      const SurfaceMatch edge(first.points[match], first.normals[match], second.points[k], second.normals[k]);
      graph.add_edge(edge, edge.information(), x0, x1);
    }
    if (!optimize(graph).converged()) return 1;
    moves = (graph.estimate(x1).vector() - motion.vector()).norm() > 1e-4;
    motion = graph.estimate(x1);
  }

  Vector<double, 6> error;
  Manifold<SE3>::ominus(motion, kMotion, error.data());
  const double distance = error.head<3>().norm(), degrees = 2 * error.tail<3>().norm() * 180 / kPi;
  std::printf("two scans of %zu points; no point is in both\n", first.points.size());
  std::printf(
      "motion after %d rounds: (%.3f, %.3f, %.3f) m; error %.1f mm (%.0f mm at the start), %.3f degrees\n",
      rounds, motion.translation().x(), motion.translation().y(), motion.translation().z(), 1000 * distance,
      1000 * kMotion.translation().norm(), degrees);
  return distance < 0.01 && degrees < 0.2 ? 0 : 1;
}
