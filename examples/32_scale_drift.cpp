// SPDX-License-Identifier: BSD-3-Clause
// A monocular camera flies around a sphere, from pole to pole. It measures motions up to an unknown scale,
// which it carries over from keyframe to keyframe, with a small error each time: the scale drifts. Keyframes
// are similarities, so that loop closures correct the scale along with the pose (Strasdat, Montiel and
// Davison, "Scale drift-aware large scale monocular SLAM", 2010).
#include <boxplus/boxplus.h>
#include <boxplus/types/ba/similarity.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

using namespace boxplus;

constexpr int kLaps = 16, kViewsOfALap = 40, kViews = kLaps * kViewsOfALap;
constexpr double kRadius = 10;
// Standard deviations of a measured motion: rotation (rad), translation (m), log of the scale.
constexpr double kTurnNoise = 0.002, kShiftNoise = 0.02, kScaleNoise = 0.02;

Vector<double, 7> sigmas() {
  Vector<double, 7> values;
  values << kTurnNoise, kTurnNoise, kTurnNoise, kShiftNoise, kShiftNoise, kShiftNoise, kScaleNoise;
  return values;
}

/// The true keyframe k. All scales are 1.
Sim3 true_keyframe(int k) {
  const double heading = 2 * kPi * k / kViewsOfALap, latitude = kPi * ((k + 0.5) / kViews - 0.5);
  const SO3 turn =
      SO3::from_rotation_vector(Vector3(0, 0, heading)) * SO3::from_rotation_vector(Vector3(0, -latitude, 0));
  return Sim3(turn.quaternion(), kRadius * (turn * Vector3(1, 0, 0)), 1.0);
}

/// The root mean square of the errors of positions (m). `position(k)` is the estimate of keyframe k.
template <class Position>
double position_error(const Position& position) {
  double squares = 0;
  for (int k = 0; k < kViews; ++k) squares += (position(k) - true_keyframe(k).translation()).squaredNorm();
  return std::sqrt(squares / kViews);
}

/// A similarity without its scale.
SE3 rigid(const Sim3& x) {
  return SE3::from_unit(x.translation(), x.quaternion());
}

struct Loop {
  std::size_t from, to;
  Sim3 motion;
};

/// The same problem with rigid poses, whose scale cannot change. Returns the error of the positions.
double error_of_rigid_poses(const std::vector<Sim3>& odometry, const std::vector<Loop>& loops) {
  const Information omega = Information::se3_sigmas(kShiftNoise, kTurnNoise);
  Graph graph;
  std::vector<VertexHandle<SE3>> poses;
  for (std::size_t k = 0; k < odometry.size(); ++k) {
    poses.push_back(graph.add_vertex(rigid(odometry[k])));
    if (k > 0) {
      const SE3 motion = rigid(odometry[k - 1]).inverse_times(rigid(odometry[k]));
      graph.add_edge(Between(motion), omega, poses[k - 1], poses[k]);
    }
  }
  graph.fix(poses[0]);
  for (const auto& [from, to, motion] : loops) {
    const SE3 scaled = SE3::from_unit(odometry[from].scale() * motion.translation(), motion.quaternion());
    graph.add_edge(Between(scaled), omega, poses[from], poses[to]);
  }
  if (!optimize(graph).converged()) throw InvalidArgument("the rigid poses do not converge");
  return position_error(
      [&](int k) { return graph.estimate(poses[static_cast<std::size_t>(k)]).translation(); });
}

int main() {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  const Vector<double, 7> sigma = sigmas();
  const auto measured = [&](int from, int to) {
    Vector<double, 7> noise;
    for (int i = 0; i < 7; ++i) noise[i] = sigma[i] * normal(random);
    return Sim3(true_keyframe(from).inverse() * true_keyframe(to) * Sim3::exp(noise));
  };
  double weights[7];
  for (int i = 0; i < 7; ++i) weights[i] = 1 / (sigma[i] * sigma[i]);
  const Information omega = Information::diagonal(weights);

  std::vector<Sim3> odometry{true_keyframe(0)};
  std::vector<Loop> loops;
  Graph graph;
  std::vector<VertexHandle<SimilarityCamera>> keyframes;
  SimilarityCamera camera;  // its intrinsics are not used here
  for (int k = 0; k < kViews; ++k) {
    const Sim3 motion = k > 0 ? measured(k - 1, k) : Sim3();
    if (k > 0) odometry.push_back(odometry.back() * motion);
    camera.similarity = LoggedSim3(odometry.back());
    keyframes.push_back(graph.add_vertex(camera));
    if (k > 0) {
      graph.add_edge(SimilarityBetween(LoggedSim3(motion)), omega, keyframes[keyframes.size() - 2],
                     keyframes.back());
    }
  }
  graph.fix(keyframes[0]);
  for (int k = kViewsOfALap; k < kViews; k += 2) {
    const auto now = static_cast<std::size_t>(k), then = now - kViewsOfALap;  // the place one lap before
    loops.push_back({then, now, measured(k - kViewsOfALap, k)});
    graph.add_edge(SimilarityBetween(LoggedSim3(loops.back().motion)), omega, keyframes[then],
                   keyframes[now]);
  }
  const auto estimate = [&](int k) { return graph.estimate(keyframes[static_cast<std::size_t>(k)]).pose(); };
  const auto position = [&](int k) { return estimate(k).translation(); };
  const auto scale_error = [&] {
    double worst = 0;
    for (int k = 0; k < kViews; ++k) worst = std::max(worst, std::abs(std::log(estimate(k).scale())));
    return std::exp(worst);
  };
  const double start = position_error(position), start_scale = scale_error();
  const double with_rigid_poses = error_of_rigid_poses(odometry, loops);
  const Report report = optimize(graph);
  const double end = position_error(position), end_scale = scale_error();

  std::printf(
      "odometry of %d keyframes: position error %.2f m (RMS), scale wrong by a factor of up to %.2f\n",
      kViews, start, start_scale);
  std::printf("with %zu loop closures and rigid poses: position error %.2f m\n", loops.size(),
              with_rigid_poses);
  std::printf(
      "with %zu loop closures and similarities: position error %.2f m, scale within a factor of %.3f\n",
      loops.size(), end, end_scale);
  std::printf("chi2 per degree of freedom %.3f\n", report.chi2_per_degree());
  const bool had_drift = start_scale > 1.3 && start > 1 && with_rigid_poses > 2 * end;
  const bool is_right = end < 1 && end_scale < 1.2 && std::abs(report.chi2_per_degree() - 1) < 0.1;
  return report.converged() && had_drift && is_right ? 0 : 1;
}
