// SPDX-License-Identifier: BSD-3-Clause
// Three more types of vertices: products of two types, directions, and similarities.
#include <boxplus/boxplus.h>
#include <boxplus/manifold/product.h>
#include <boxplus/manifold/s2.h>
#include <boxplus/manifold/sim3.h>

#include <cmath>
#include <cstdio>
#include <vector>

using namespace boxplus;

// [product]
/// A pose and its velocity (m/s, in the world), in one vertex with 9 unknowns.
using State = Product<SE3, Vector3>;

/// Constant velocity: the position changes by velocity times time, and the velocity stays the same.
struct ConstantVelocity {
  double seconds;

  template <class S>
  auto error(const S& a, const S& b) const {
    const auto& [pose_a, velocity_a] = a;
    const auto& [pose_b, velocity_b] = b;
    Vector<typename std::decay_t<decltype(pose_a)>::Scalar, 6> e;
    e << pose_b.translation() - pose_a.translation() - velocity_a * seconds, velocity_b - velocity_a;
    return e;
  }
};

/// A measurement of the body's position by a satellite receiver.
struct Fix {
  Vector3 measurement;

  template <class S>
  auto error(const S& state) const {
    return (state.template get<0>().translation() - measurement).eval();
  }
};
// [/product]

/// Returns the estimated speed (m/s) of a body whose measured x is 0, 2, 4 and 6 m in four consecutive
/// seconds.
double estimated_speed() {
  Graph graph;
  std::vector<VertexHandle<State>> states;
  for (int i = 0; i < 4; ++i) {
    states.push_back(graph.add_vertex(State(SE3(), Vector3::Zero())));
    graph.add_edge(Fix{Vector3(2.0 * i, 0, 0)}, 100.0, states.back());
    graph.add_edge([](const auto& state) { return state.template get<0>().quaternion().z; }, 1.0,
                   states.back());
    graph.add_edge([](const auto& state) { return state.template get<0>().quaternion().y; }, 1.0,
                   states.back());
    graph.add_edge([](const auto& state) { return state.template get<0>().quaternion().x; }, 1.0,
                   states.back());
    if (i > 0) graph.add_edge(ConstantVelocity{1.0}, 1e4, states[states.size() - 2], states.back());
  }
  if (!optimize(graph).converged()) return 0;
  return graph.estimate(states.back()).get<1>().x();
}

/// Returns the angle (degrees) between the estimated direction and the true direction.
double direction_error() {
  // [direction]
  Graph graph;
  const auto up = graph.add_vertex(S2());  // initially the z axis; has 2 unknowns, because its length is 1
  for (const Vector3& measured : {Vector3(0.6, 0.1, 0.8), Vector3(0.6, -0.1, 0.8), Vector3(0.61, 0, 0.79)})
    graph.add_edge(Prior(S2(measured)), 1 / (0.1 * 0.1), up);  // sigma in radians
  if (!optimize(graph).converged()) return 180;
  const Vector3 found = graph.estimate(up).vector();
  // [/direction]
  return std::acos(std::min(1.0, found.dot(Vector3(0.6, 0, 0.8)))) * 180 / kPi;
}

/// Returns the estimated scale of the last keyframe of a camera that returned to its start. The true scale is
/// 1.
double scale_at_the_end() {
  // [similarity]
  // The scale of a monocular map drifts if no length is known. Here, the scale drifts by 5 % along every side
  // of a square. Each keyframe is a similarity, so the loop closure can distribute the drift over all
  // keyframes.
  const Vector3 meter(1, 0, 0);
  const auto turn = SO3::from_rotation_vector(Vector3(0, 0, kPi / 2)).quaternion();
  const Sim3 measured(turn, meter, 1.05), closing(turn, meter, 1.0);
  Graph graph;
  std::vector<VertexHandle<Sim3>> keyframes{graph.add_vertex(Sim3())};
  graph.fix(keyframes[0]);
  for (int i = 0; i < 3; ++i) {
    keyframes.push_back(graph.add_vertex(graph.estimate(keyframes.back()) * measured));
    graph.add_edge(Between(measured), 100.0, keyframes[keyframes.size() - 2], keyframes.back());
  }
  graph.add_edge(Between(closing), 1e6, keyframes.back(), keyframes.front());
  if (!optimize(graph).converged()) return 0;
  const double scale = graph.estimate(keyframes.back()).scale();
  // [/similarity]
  return scale;
}

int main() {
  const double speed = estimated_speed(), degrees = direction_error(), scale = scale_at_the_end();
  std::printf("speed %.2f m/s; direction within %.1f degrees; scale %.3f (%.3f without the loop closure)\n",
              speed, degrees, scale, std::pow(1.05, 3));
  return std::abs(speed - 2) < 1e-3 && degrees < 1 && std::abs(scale - 1) < 0.01 ? 0 : 1;
}
