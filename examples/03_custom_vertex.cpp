// SPDX-License-Identifier: BSD-3-Clause
// A custom vertex type: fits a circle to measured points.
//
// Any copyable type becomes a vertex when the trait Manifold<T> is specialized for it. The trait states the
// number of degrees of freedom (kDim). Its function oplus (⊞) adds a small step to a value, and its function
// ominus (⊟) returns the step between two values. The type itself stays unchanged, and may come from another
// library.
#include <boxplus/boxplus.h>
#include <boxplus/testing/check_manifold.h>

#include <cmath>
#include <cstdio>

using namespace boxplus;

// [type]
template <class S>
struct BasicCircle {
  Vector<S, 2> center;
  S radius;
};
using Circle = BasicCircle<double>;
// [/type]

// [trait]
template <class S>
struct boxplus::Manifold<BasicCircle<S>> {
  static constexpr int kDim = 3;

  /// Multiplies the radius by an exponential, so that it stays positive for any step.
  static BasicCircle<S> oplus(const BasicCircle<S>& x, const S* delta) {
    using std::exp;
    return {Vector<S, 2>(x.center[0] + delta[0], x.center[1] + delta[1]), x.radius * exp(delta[2])};
  }
  static void ominus(const BasicCircle<S>& y, const BasicCircle<S>& x, S* delta) {
    using std::log;
    delta[0] = y.center[0] - x.center[0];
    delta[1] = y.center[1] - x.center[1];
    delta[2] = log(y.radius / x.radius);
  }

  // With these two members, boxplus differentiates edges automatically and exactly. Without them, it
  // differentiates edges numerically.
  template <class T>
  using Rebind = BasicCircle<T>;
  template <class T>
  static BasicCircle<T> cast(const BasicCircle<S>& x) {
    return {x.center.template cast<T>(), T(x.radius)};
  }
};
// [/trait]

// [edge]
/// The distance (meters) of a measured point from the circle: positive outside, negative inside.
struct PointOnCircle {
  Vector2 point;

  template <class S>
  S error(const BasicCircle<S>& circle) const {
    return (point - circle.center).norm() - circle.radius;
  }
};
// [/edge]

bool laws_hold() {
  // [check_manifold]
  const ManifoldCheck check = check_manifold<Circle>({{Vector2(0, 0), 1}, {Vector2(3, -2), 0.01}});
  if (!check) std::printf("%s\n", check.message.c_str());
  // [/check_manifold]
  return check.ok;
}

int main() {
  // [graph]
  Graph graph;
  const auto circle = graph.add_vertex(Circle{Vector2(0, 0), 1});
  for (const double angle : {0.1, 0.7, 1.2, 2.0, 2.9, 3.3, 4.4, 5.6}) {
    const double radius = 2 + 0.01 * std::sin(40 * angle);  // the true radius is 2; with a little noise
    graph.add_edge(PointOnCircle{Vector2(3 + radius * std::cos(angle), -1 + radius * std::sin(angle))},
                   circle);
  }
  const Report report = optimize(graph);
  const Circle& found = graph.estimate(circle);
  std::printf("center (%.2f, %.2f), radius %.2f\n", found.center.x(), found.center.y(), found.radius);
  // [/graph]

  const bool is_right = (found.center - Vector2(3, -1)).norm() < 0.02 && std::abs(found.radius - 2) < 0.02;
  return report.converged() && is_right && laws_hold() ? 0 : 1;
}
