// SPDX-License-Identifier: BSD-3-Clause
// Online SLAM: a robot drives around a block, and its map is at the optimum after each step. A loop closure
// is looked at before it counts, so that a false one changes nothing.
#include <boxplus/boxplus.h>
#include <boxplus/incremental/smoother.h>
#include <boxplus/types/slam2d.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

using namespace boxplus;

class OnlineSlam {
 public:
  OnlineSlam() : poses{graph.add_vertex(SE2())}, smoother(graph) { graph.fix(poses[0]); }

  // [step]
  /// Adds a pose, with the odometry from the last pose to it.
  SmootherReport drive(const SE2& odometry) {
    const auto last = poses.back();
    poses.push_back(graph.add_vertex(graph.estimate(last) * odometry));
    const double weights[] = {2500, 2500, 40000};  // of x, y and θ: 2 cm, 2 cm, 5 mrad
    graph.add_edge(Between(odometry), Information::diagonal(weights), last, poses.back());
    return smoother.update();
  }
  // [/step]

  // [close]
  /// Adds a loop closure if it agrees with all other edges. Otherwise, leaves the graph as it was.
  bool close(VertexHandle<SE2> from, VertexHandle<SE2> to, const SE2& seen) {
    const auto edge = graph.add_edge(Between(seen), 400.0, from, to);
    graph.set_enabled(edge, false);  // no update takes it into account
    const double believable = 16.3;  // a right edge of 3 rows exceeds it in one of 1000 cases
    if (smoother.preview(edge).chi2_increase > believable) {
      graph.remove(edge);
      return false;
    }
    graph.set_enabled(edge, true);
    return true;
  }
  // [/close]

  Graph graph;
  std::vector<VertexHandle<SE2>> poses;
  Smoother smoother;
};

/// The largest distance of a pose from its place after a run of optimize().
double distance_from_batch(const OnlineSlam& slam) {
  Graph copy = slam.graph;
  if (!optimize(copy).converged()) return 1e9;
  double largest = 0;
  for (const auto& pose : slam.poses) {
    const SE2 apart = copy.estimate(pose).inverse() * slam.graph.estimate(pose);
    largest = std::max(largest, std::hypot(apart.x(), apart.y()));
  }
  return largest;
}

int main() {
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  const auto noisy = [&](const SE2& pose, double meters, double radians) {
    return pose * SE2(meters * normal(random), meters * normal(random), radians * normal(random));
  };
  constexpr std::size_t kLap = 40;  // poses of a lap: four sides of 10 m
  OnlineSlam slam;
  std::size_t accepted = 0, refused = 0, failures = 0, most_moved = 0, moved = 0;
  double worst = 0;
  for (std::size_t k = 1; k <= 5 * kLap; ++k) {
    const SE2 motion(1, 0, k % 10 == 0 ? kPi / 2 : 0);
    SmootherReport report = slam.drive(noisy(motion, 0.02, 0.005));
    // After the first lap, the robot recognizes some places. Once, it mistakes one corner for the next one.
    if (k > kLap && k % 5 == 0) {
      const bool is_false = k == 3 * kLap + 10;
      const std::size_t seen = is_false ? k - kLap + 10 : k - kLap;  // the robot is there: relative pose 0
      const bool is_accepted = slam.close(slam.poses[k], slam.poses[seen], noisy(SE2(), 0.05, 0.05));
      (is_accepted ? accepted : refused) += 1;
      failures += is_accepted == is_false ? 1 : 0;
      report = slam.smoother.update();
    }
    // [report]
    if (!report.message.empty()) {  // nothing has moved; the message names the vertex or the edge
      std::printf("step %zu: %s\n", k, report.message.c_str());
      return 1;
    }
    moved += report.moved;  // computed estimates; all others hardly change
    most_moved = std::max<std::size_t>(most_moved, report.moved);
    // [/report]
    if (k % 10 == 0) worst = std::max(worst, distance_from_batch(slam));
  }

  // [newest]
  const Eigen::MatrixXd sigma = slam.smoother.covariance({slam.poses.back()});
  std::printf("standard deviations of the newest pose: %.3f m, %.3f m, %.4f rad\n", std::sqrt(sigma(0, 0)),
              std::sqrt(sigma(1, 1)), std::sqrt(sigma(2, 2)));
  // [/newest]
  const SmootherReport last = slam.smoother.finish();
  const double finished = distance_from_batch(slam);
  std::printf("%u poses, %u edges; closures: %zu accepted, %zu refused\n", last.vertices, last.edges,
              accepted, refused);
  std::printf("computed estimates per step: %zu on average, %zu at most\n", moved / (5 * kLap), most_moved);
  std::printf("distance from the optimum: %.0f mm at most during the drive, %.0f um in the end\n",
              1e3 * worst, 1e6 * finished);
  return last.converged() && failures == 0 && refused == 1 && worst < 0.01 && finished < 1e-5 ? 0 : 1;
}
