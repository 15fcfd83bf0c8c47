// SPDX-License-Identifier: BSD-3-Clause
// The counterpart of the other files in this folder: this file has no error, so it must compile.
#include <span>
#include <vector>

#include "boxplus/graph/graph.h"
#include "boxplus/manifold/rn.h"

/// An edge with the analytic Jacobian jacobians(). Its data member `jacobian` must not cause the error that a
/// member function of this name causes.
struct Square {
  boxplus::Matrix<double, 1, 1> jacobian;
  template <class S>
  S error(const S& x) const {
    return x * x;
  }
  void jacobians(double x, Eigen::Ref<boxplus::Matrix<double, 1, 1>> J) const { J(0, 0) = 2 * x; }
};

/// A linear error. Its members `jacobian` and `jacobians` are data, so they must not cause an error either.
struct Linear {
  double jacobian, jacobians;
  template <class S>
  S error(const S& x) const {
    return jacobian * x;
  }
};

/// An edge that has an analytic Jacobian only if T is double.
template <class T>
struct Doubled {
  static constexpr bool kJacobiansForSomeTypes = true;
  template <class X>
  X error(const X& x) const {
    return 2.0 * x;
  }
  void jacobians(double /*x*/,
                 Eigen::Ref<boxplus::Matrix<double, 1, 1>> J) const requires std::same_as<T, double> {
    J(0, 0) = 2;
  }
};

struct Final final {
  double error(double x) const { return x; }
};

double half(double x) {
  return x / 2;
}

void control(boxplus::Graph& graph) {
  const auto a = graph.add_vertex(Eigen::Vector2d(1, 2));
  const std::vector<boxplus::VertexHandle<double>> rest{graph.add_vertex(1.0)};
  graph.add_edge([](const auto& x) { return (2.0 * x).eval(); }, a);
  graph.add_edge([](const auto& x, const auto& tail) { return x[0] - tail[0]; }, a, rest);
  graph.add_edge([](const Eigen::VectorXd& x) { return x[0]; }, a);
  graph.add_edge([](std::span<const boxplus::Vector2> points) { return points[0][0]; }, std::vector{a});
  graph.add_edge([](std::span<const Eigen::Vector2d> points) { return points[0][0]; }, std::vector{a});
  graph.add_edge(Square{}, rest[0]);
  graph.add_edge(Linear{1, 2}, rest[0]);
  graph.add_edge(Doubled<double>{}, rest[0]);
  graph.add_edge(Doubled<boxplus::Vector2>{}, a);
  graph.add_edge(Final{}, rest[0]);
  graph.add_edge(&half, rest[0]);
}
