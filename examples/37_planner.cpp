// SPDX-License-Identifier: BSD-3-Clause
// A planner that runs 20 times per second: a robot drives to a goal, and an obstacle crosses its path. The
// plan is a trajectory over the next 3 s. Each tick fixes the state that the robot has reached, adds one
// state at the end, and moves the obstacle and the goal to where they are seen.
#include <boxplus/boxplus.h>
#include <boxplus/incremental/smoother.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <deque>

using namespace boxplus;

constexpr double kTick = 0.05;      // seconds between two ticks, and between two states of the plan
constexpr int kHorizon = 60;        // states of the plan
constexpr double kSpeed = 2;        // m/s
using Vector4 = Vector<double, 4>;  // position and velocity in the plane

/// Constant velocity between two consecutive states.
struct Smoothness {
  template <class S>
  Vector<S, 4> error(const Vector<S, 4>& a, const Vector<S, 4>& b) const {
    Vector<S, 4> e;
    for (int i = 0; i < 2; ++i) {
      e[i] = b[i] - a[i] - kTick * (a[i + 2] + b[i + 2]) / 2.0;
      e[i + 2] = b[i + 2] - a[i + 2];
    }
    return e;
  }
};

/// Drives toward the goal at kSpeed, and more slowly in the last meters.
struct Goal {
  Vector2 place;

  template <class S>
  Vector<S, 2> error(const Vector<S, 4>& state) const {
    using std::sqrt;
    const S x = place[0] - state[0], y = place[1] - state[1];
    const S scale = kSpeed / sqrt(x * x + y * y + 4.0);
    Vector<S, 2> e;
    e << state[2] - scale * x, state[3] - scale * y;
    return e;
  }
};

/// Keeps away from a disk with a margin. Outside, the error falls smoothly to zero.
struct Obstacle {
  Vector2 center;
  double radius;

  template <class S>
  S error(const Vector<S, 4>& state) const {
    using std::exp, std::log, std::sqrt;
    constexpr double kMargin = 0.5, kSoftness = 0.1;
    const S x = state[0] - center[0], y = state[1] - center[1];
    const S inside = (radius + kMargin - sqrt(x * x + y * y + 1e-6)) / kSoftness;
    return kSoftness * (inside > 30.0 ? inside : S(log(1.0 + exp(inside))));
  }
};

class Planner {
 public:
  Planner(const Vector4& start, const Vector2& goal, const Obstacle& obstacle)
      : smoother_(graph_, {.time_limit_s = 0.04}) {
    states_.push_back({graph_.add_vertex(start), {}, {}});
    graph_.fix(states_[0].vertex);
    while (states_.size() <= kHorizon) append(goal, obstacle);
    smoother_.update();
  }

  // [tick]
  /// The robot has reached the next state of the plan. The obstacle moves with `velocity`.
  SmootherReport tick(const Vector2& goal, const Obstacle& obstacle, const Vector2& velocity) {
    graph_.fix(states_[1].vertex);  // the robot is there
    graph_.remove(states_[0].vertex);
    states_.pop_front();
    append(goal, obstacle);
    for (std::size_t k = 1; k < states_.size(); ++k) {
      const Vector2 center = obstacle.center + (kTick * static_cast<double>(k)) * velocity;
      graph_.set_measurement(states_[k].obstacle, Obstacle{center, obstacle.radius});
      graph_.set_measurement(states_[k].goal, Goal{goal});
    }
    return smoother_.update();
  }
  // [/tick]

  const Vector4& now() const { return graph_.estimate(states_[0].vertex); }
  std::size_t vertices() const { return graph_.vertex_count(); }

 private:
  struct State {
    VertexHandle<Vector4> vertex;
    EdgeHandle<Goal> goal;
    EdgeHandle<Obstacle> obstacle;
  };

  void append(const Vector2& goal, const Obstacle& obstacle) {
    const auto last = states_.back().vertex;
    Vector4 next = graph_.estimate(last);
    next.head<2>() += kTick * next.tail<2>();
    const auto vertex = graph_.add_vertex(next);
    const double smoothness[] = {4e4, 4e4, 400, 400};
    graph_.add_edge(Smoothness{}, Information::diagonal(smoothness), last, vertex);
    states_.push_back(
        {vertex, graph_.add_edge(Goal{goal}, 1.0, vertex), graph_.add_edge(obstacle, 400.0, vertex)});
  }

  Graph graph_;
  Smoother smoother_;
  std::deque<State> states_;
};

int main() {
  Vector2 goal(20, 0), velocity(0, -0.6);
  Obstacle obstacle{Vector2(8, 3), 1.0};
  Planner planner(Vector4(0, 0, 0, 0), goal, obstacle);
  double clearance = 1e9, fastest = 0;
  int ticks = 0, unfinished = 0;
  for (; ticks < 600; ++ticks) {
    if (ticks == 100) velocity = Vector2(0.2, 0.2);  // the obstacle turns back
    if (ticks == 150) goal = Vector2(18, 6);         // somebody moves the goal
    const SmootherReport report = planner.tick(goal, obstacle, velocity);
    if (!report.message.empty()) {
      std::printf("tick %d: %s\n", ticks, report.message.c_str());
      return 1;
    }
    unfinished += report.converged() ? 0 : 1;  // the next tick goes on
    obstacle.center += kTick * velocity;
    const Vector2 place = planner.now().head<2>();
    clearance = std::min(clearance, (place - obstacle.center).norm() - obstacle.radius);
    fastest = std::max(fastest, planner.now().tail<2>().norm());
    if ((place - goal).norm() < 0.3) break;
  }
  std::printf("arrived after %.1f s; the plan has %zu vertices\n", kTick * ticks, planner.vertices());
  std::printf("distance from the obstacle: at least %.2f m; speed: at most %.1f m/s\n", clearance, fastest);
  if (unfinished > 0) std::printf("ticks that reached the time limit: %d\n", unfinished);
  return clearance > 0.2 && ticks < 600 && planner.vertices() == kHorizon + 1 ? 0 : 1;
}
