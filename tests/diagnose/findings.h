// SPDX-License-Identifier: BSD-3-Clause
// Healthy graphs to spoil, and matchers for the findings of a diagnosis.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "boxplus/diagnose/diagnose.h"
#include "boxplus/types/ba.h"
#include "boxplus/types/prior.h"
#include "optimize/small_graphs.h"

namespace boxplus {

using Kind = Finding::Kind;
using Severity = Finding::Severity;

/// The only finding of this kind. Fails if there is another number of them.
inline Finding only(const Diagnosis& diagnosis, Kind kind) {
  std::vector<Finding> found;
  for (const Finding& finding : diagnosis.findings) {
    if (finding.kind == kind) found.push_back(finding);
  }
  EXPECT_EQ(found.size(), 1u) << to_string(kind) << " in\n" << diagnosis;
  return found.empty() ? Finding{} : found.front();
}

MATCHER_P(HasFinding, kind, std::string(to_string(kind))) {
  for (const Finding& finding : arg.findings) {
    if (finding.kind == kind) return true;
  }
  return false;
}

/// The difference of two points. Some entries of the Jacobian by the second point are multiplied by `factor`.
struct Difference {
  static constexpr std::string_view kName = "Difference";
  Vector2 measurement;
  double factor = 1;

  template <class S>
  Vector<S, 2> error(const Vector<S, 2>& a, const Vector<S, 2>& b) const {
    return b - a - measurement.template cast<S>();
  }
  template <class A, class B>
  void jacobians(const Vector2&, const Vector2&, A& J_a, B& J_b) const {
    J_a = -Eigen::Matrix2d::Identity();
    J_b = Eigen::Matrix2d::Identity();
    J_b(1, 1) *= factor;
  }
};

/// A chain of points, whose Jacobians are right if the factor is 1.
inline Graph chain_with_wrong_jacobian(double factor) {
  Graph graph;
  std::vector<VertexHandle<Vector2>> points{graph.add_vertex(Vector2(0, 0))};
  graph.fix(points.front());
  for (int k = 0; k < 20; ++k) {
    points.push_back(graph.add_vertex(Vector2(k + 1, 0.5 * k)));
    graph.add_edge(Difference{Vector2(1, 0.5), factor}, points[points.size() - 2], points.back());
  }
  return graph;
}

/// A circle of poses at a minimum of chi2. The first pose is fixed.
struct HealthyCircle {
  Graph graph;
  std::vector<VertexHandle<SE2>> poses;

  explicit HealthyCircle(int count = 40) {
    poses = add_noisy_circle(graph, count);
    graph.fix(poses.front());
    EXPECT_TRUE(optimize(graph).converged());
  }
  EdgeRef edge(std::size_t k) const { return graph.all_edges()[k]; }
};

/// Cameras side by side that see points in front of them, at the true estimates. The first two are fixed.
struct HealthyCameras {
  static constexpr double kFocalLength = 500;
  Graph graph;
  std::vector<VertexHandle<SE3>> cameras;
  std::vector<VertexHandle<Vector3>> points;

  explicit HealthyCameras(int count = 12) {
    for (int i = 0; i < 4; ++i) cameras.push_back(graph.add_vertex(SE3(Vector3(i, 0.1 * i, 0), SO3())));
    graph.fix(cameras[0]);
    graph.fix(cameras[1]);
    for (int k = 0; k < count; ++k) {
      points.push_back(graph.add_vertex(
          Vector3(3 * std::sin(1.3 * k), std::sin(2.1 * k), 10 + std::sin(3.7 * k)), Id{100} + k));
      for (const auto& camera : cameras) see(camera, points.back());
    }
  }
  /// Adds a measurement with an error of up to one pixel.
  EdgeHandle<CalibratedReprojection<PinholeCamera>> see(VertexHandle<SE3> camera,
                                                        VertexHandle<Vector3> point) {
    const PinholeCamera model(kFocalLength, kFocalLength, 320.0, 240.0);
    const Vector3 local = graph.estimate(camera).inverse_times(graph.estimate(point));
    const double noise = std::sin(static_cast<double>(graph.edge_count()));
    const Vector2 pixel = model.project(local) + Vector2(noise, noise * noise - 0.5);
    return graph.add_edge(CalibratedReprojection<PinholeCamera>(pixel, model), camera, point);
  }
};

}  // namespace boxplus
