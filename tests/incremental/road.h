// SPDX-License-Identifier: BSD-3-Clause
// A robot that drives with a fixed lag, for tests and benchmarks of the Smoother.
#pragma once

#include <Eigen/Cholesky>
#include <cstddef>
#include <deque>
#include <vector>

#include "boxplus/incremental/smoother.h"
#include "boxplus/types/slam2d.h"
#include "testing/random_numbers.h"

namespace boxplus {

/// (x̂ ⊟ x)ᵀ Σ⁻¹ (x̂ ⊟ x) of one vertex: its normalized estimation error squared.
template <class T>
double nees(const Graph& graph, const Smoother& smoother, VertexHandle<T> vertex, const T& truth) {
  Eigen::Matrix<double, Manifold<T>::kDim, 1> error;
  Manifold<T>::ominus(graph.estimate(vertex), truth, error.data());
  return error.dot(smoother.covariance({vertex}).ldlt().solve(error));
}

/// A robot that drives around a block, 1 m per step, and sees landmarks beside the road.
class Road {
 public:
  Road(unsigned seed, std::size_t lag) : random_(seed), smoother_(graph_, {.lag = lag}) {
    add_pose(SE2());
    const SE2 start(noise(kStart), noise(kStart), noise(kStart));
    graph_.add_edge(Prior(start), 1 / (kStart * kStart), pose_);
  }

  SmootherReport step() {
    const SE2 motion(1, 0, kTurn);
    truth_ = truth_ * motion;
    const SE2 measured = motion * SE2(noise(kMotion), noise(kMotion), noise(kTurnNoise));
    const auto last = pose_;
    add_pose(graph_.estimate(last) * measured);
    std::vector<double> omega{1 / (kMotion * kMotion), 1 / (kMotion * kMotion),
                              1 / (kTurnNoise * kTurnNoise)};
    graph_.add_edge(Between(measured), Information::diagonal(omega), last, pose_);
    observe();
    return smoother_.update();
  }

  /// nees() of the newest pose.
  double nees_of_pose() const { return nees(graph_, smoother_, pose_, truth_); }
  const Graph& graph() const { return graph_; }

 private:
  static constexpr double kTurn = 2e-3, kMotion = 0.02, kTurnNoise = 0.002, kSeen = 0.1, kStart = 0.01;
  struct Landmark {
    Vector2 place;
    VertexHandle<Vector2> vertex;
    bool is_known = false;
  };

  double noise(double sigma) { return sigma * random_.normal(); }

  void add_pose(const SE2& guess) {
    pose_ = graph_.add_vertex(guess);
    // Two new landmarks ahead, one on each side of the road.
    for (const double side : {-6.0, 6.0}) {
      const Vector2 local(12 + noise(1), side + noise(1));
      if (random_.uniform() < 0.3) landmarks_.push_back({truth_ * local, {}, false});
    }
    while (!landmarks_.empty() && truth_.inverse_times(landmarks_.front().place)[0] < -12)
      landmarks_.pop_front();
  }

  void observe() {
    for (Landmark& landmark : landmarks_) {
      const Vector2 exact = truth_.inverse_times(landmark.place);
      if (exact.norm() > 12) continue;
      const Vector2 seen(exact[0] + noise(kSeen), exact[1] + noise(kSeen));
      if (!landmark.is_known) landmark.vertex = graph_.add_vertex(graph_.estimate(pose_) * seen);
      landmark.is_known = true;
      if (!graph_.contains(landmark.vertex)) continue;
      graph_.add_edge(PointObservation2(seen), 1 / (kSeen * kSeen), pose_, landmark.vertex);
    }
  }

  RandomNumbers random_;
  Graph graph_;
  Smoother smoother_;
  SE2 truth_;
  VertexHandle<SE2> pose_;
  std::deque<Landmark> landmarks_;
};

}  // namespace boxplus
