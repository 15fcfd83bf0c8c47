// SPDX-License-Identifier: BSD-3-Clause
// Graphs for the tests of initial guesses.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "guess/frame_types.h"
#include "guess/initial_guess.h"
#include "optimize/table_entries.h"

namespace boxplus::test {

/// A graph whose true poses and positions are known. Its measurements are exact, and its estimates arbitrary.
template <class World>
class Scene {
 public:
  using Motion = typename World::Motion;
  using PoseHandle = VertexHandle<Pose<World>>;
  using PointHandle = VertexHandle<Point<World>>;

  PoseHandle add_pose(double seed, std::optional<Id> id = std::nullopt) {
    truth_.push_back(World::motion(seed));
    poses_.push_back(graph.add_vertex(Pose<World>{arbitrary_motion(poses_.size())}, id));
    return poses_.back();
  }
  PointHandle add_point(double seed, std::optional<Id> id = std::nullopt) {
    positions_.push_back(World::motion(seed).translation());
    points_.push_back(graph.add_vertex(Point<World>{arbitrary_motion(points_.size()).translation()}, id));
    return points_.back();
  }
  EdgeHandle<Between<World>> join(PoseHandle a, PoseHandle b, Information information = 1.0) {
    return graph.add_edge(Between<World>{truth(a).inverse() * truth(b)}, information, a, b);
  }
  void see(PoseHandle a, PointHandle b) {
    graph.add_edge(Sighting<World>{truth(a).inverse() * truth(b)}, a, b);
  }
  void fix(PoseHandle pose) {
    graph.set_estimate(pose, Pose<World>{truth(pose)});
    graph.fix(pose);
  }
  void fix(PointHandle point) {
    graph.set_estimate(point, Point<World>{truth(point)});
    graph.fix(point);
  }

  Motion truth(PoseHandle pose) const { return truth_[index(poses_, pose)]; }
  PointError<World> truth(PointHandle point) const { return positions_[index(points_, point)]; }

  GuessResult apply(std::size_t k, const PlanRequest& request = {}) {
    return every_guess()[k].guess(graph, make_plan(graph, request), {});
  }
  /// Expects that the k-th initial guess finds the true poses and positions.
  void expect_truth_from(std::size_t k, const PlanRequest& request = {}) {
    EXPECT_TRUE(apply(k, request).made);
    EXPECT_LT(largest_error(), 1e-9);
  }
  double error(PoseHandle pose) const {
    const auto d = frame_of<World>(graph.estimate(pose).motion), e = frame_of<World>(truth(pose));
    double sum = 0;
    for (std::size_t i = 0; i < 9; ++i) sum += std::abs(d.rotation[i] - e.rotation[i]);
    for (std::size_t i = 0; i < 3; ++i) sum += std::abs(d.translation[i] - e.translation[i]);
    return sum;
  }
  double error(PointHandle point) const { return (graph.estimate(point).position - truth(point)).norm(); }
  double largest_error() const {
    double largest = 0;
    for (PoseHandle pose : poses_) largest = std::max(largest, error(pose));
    for (PointHandle point : points_) largest = std::max(largest, error(point));
    return largest;
  }

  Graph graph;

 private:
  static Motion arbitrary_motion(std::size_t k) {
    return World::motion(100.0 + 7.3 * static_cast<double>(k));
  }
  template <class H>
  static std::size_t index(const std::vector<H>& handles, const H& handle) {
    return static_cast<std::size_t>(std::find(handles.begin(), handles.end(), handle) - handles.begin());
  }

  std::vector<PoseHandle> poses_;
  std::vector<PointHandle> points_;
  std::vector<Motion> truth_;
  std::vector<PointError<World>> positions_;
};

/// Runs `body(k)` for each kind of initial guess.
template <class F>
void for_each_guess(F&& body) {
  for (std::size_t k = 0; k < every_guess().size(); ++k) {
    SCOPED_TRACE(to_string(every_guess()[k].start));
    body(k);
  }
}

/// Five poses in a chain with loop closures, and three points. The ids of poses and points alternate.
template <class World>
std::array<typename Scene<World>::PoseHandle, 5> add_loop(Scene<World>& scene, double seed = 0) {
  std::array<typename Scene<World>::PoseHandle, 5> poses;
  std::array<typename Scene<World>::PointHandle, 3> points;
  for (std::size_t k = 0; k < 5; ++k) {
    poses[k] = scene.add_pose(seed + static_cast<double>(k));
    if (k < 3) points[k] = scene.add_point(seed + 0.3 * static_cast<double>(k));
  }
  for (std::size_t k = 0; k + 1 < 5; ++k) scene.join(poses[k], poses[k + 1]);
  scene.join(poses[4], poses[0]);
  scene.join(poses[1], poses[3], 0.5);
  for (std::size_t k = 0; k < 5; ++k) {
    for (std::size_t l = 0; l < 3; ++l) scene.see(poses[k], points[l]);
  }
  return poses;
}

using Worlds = ::testing::Types<Plane, Space>;

}  // namespace boxplus::test
