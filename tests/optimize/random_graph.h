// SPDX-License-Identifier: BSD-3-Clause
// A graph with vertices and edges of many types.
#pragma once

#include <random>
#include <vector>

#include "boxplus/graph/graph.h"
#include "boxplus/robust/huber.h"
#include "boxplus/types/slam2d.h"
#include "boxplus/types/slam3d.h"

namespace boxplus {

/// Poses and landmarks in the plane and in space, a sensor offset that is calibrated, vectors of run-time
/// size, hyper-edges, and edges with kernels. One pose in the plane and one pose in space are fixed.
struct RandomGraph {
  Graph graph;
  std::vector<VertexRef> moving, all;

  explicit RandomGraph(unsigned seed, bool eliminate) : random_(seed) {
    std::vector<VertexHandle<SE2>> poses2;
    std::vector<VertexHandle<SE3>> poses3;
    for (int k = 0; k < 6; ++k) {
      poses2.push_back(add(SE2(normal(), normal(), normal())));
      poses3.push_back(add(random_se3()));
    }
    fix(poses2[0]);
    fix(poses3[0]);
    const auto offset = graph.add_parameter(SE3(0.1 * vector3(), detail::Quaternion<double>::identity()));
    graph.unfix(offset);
    moving.push_back(offset);
    all.push_back(offset);
    for (std::size_t k = 1; k < 6; ++k) {
      join(Between(graph.estimate(poses2[k - 1]).inverse_times(graph.estimate(poses2[k])) * SE2(0.1, 0, 0.1)),
           poses2[k - 1], poses2[k]);
      join(Between(graph.estimate(poses3[k - 1]).inverse_times(graph.estimate(poses3[k]))), poses3[k - 1],
           poses3[k]);
      join(PositionPrior(Vector3(graph.estimate(poses3[k]).translation() + 0.1 * vector3())), poses3[k]);
    }
    join(kSeen, poses3[1], offset, add(vector3()));
    join(kSeen, poses3[2], offset, add(vector3()));
    graph.add_edge([](const auto& x) { return x.minimal(); }, offset);
    for (int k = 0; k < 8; ++k) landmark(poses2, Vector2(normal(), normal()), eliminate);
    for (int k = 0; k < 8; ++k) landmark(poses3, vector3(), eliminate);
    std::vector<VertexHandle<Eigen::VectorXd>> tail;
    for (int size = 1; size < 4; ++size) {
      tail.push_back(add(Eigen::VectorXd(Eigen::VectorXd::Ones(size))));
      graph.add_edge([](const Eigen::VectorXd& x) { return Eigen::VectorXd(2 * x); }, tail.back());
    }
    graph.add_edge(
        [](std::span<const Eigen::VectorXd> x) { return x[0].sum() - 3 * x[1].sum() + 0.5 * x[2].sum(); },
        tail);
  }

 private:
  static constexpr auto kSeen = [](const auto& pose, const auto& sensor, const auto& point) {
    return (pose * (sensor * point)).eval();
  };

  static PointObservation2 seen_at(const Vector2& z) { return PointObservation2(z); }
  static PointObservation3 seen_at(const Vector3& z) { return PointObservation3(z); }

  double normal() { return std::normal_distribution<double>()(random_); }
  Vector3 vector3() { return {normal(), normal(), normal()}; }
  SE3 random_se3() {
    return SE3(vector3(), detail::normalized(detail::Quaternion<double>{normal(), normal(), normal(), 1.5}));
  }

  template <class T>
  VertexHandle<T> add(T estimate) {
    const auto vertex = graph.add_vertex(std::move(estimate));
    moving.push_back(vertex);
    all.push_back(vertex);
    return vertex;
  }
  void fix(VertexRef vertex) {
    graph.fix(vertex);
    std::erase(moving, vertex);
  }
  /// Adds an edge with a random Ω. About every third edge has a kernel.
  template <class E, class... H>
  void join(E error, const H&... vertices) {
    const auto edge = graph.add_edge(std::move(error), vertices...);
    const int rows = graph.information(edge).rows;
    const Eigen::MatrixXd root = Eigen::MatrixXd::Random(rows, rows);
    graph.set_information(edge,
                          Eigen::MatrixXd(root * root.transpose() + Eigen::MatrixXd::Identity(rows, rows)));
    if (random_() % 3 == 0) graph.set_kernel(edge, Huber(0.05));
  }
  template <class Pose, class Point>
  void landmark(const std::vector<VertexHandle<Pose>>& poses, const Point& at, bool eliminate) {
    const auto point = add(at);
    graph.set_eliminated(point, eliminate);
    for (std::size_t k = random_() % 3; k < poses.size(); k += 2) {
      join(seen_at(Point(graph.estimate(poses[k]).inverse_times(at) * 1.1)), poses[k], point);
    }
  }

  std::mt19937 random_;
};

}  // namespace boxplus
