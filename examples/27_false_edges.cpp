// SPDX-License-Identifier: BSD-3-Clause
// Finds the false ones among pairs of points that should determine a pose.
#include <Eigen/Geometry>
#include <cstdio>
#include <random>

#include "boxplus/boxplus.h"
#include "boxplus/outliers/outliers.h"
#include "boxplus/types/slam3d.h"

using namespace boxplus;

int main() {
  // A sensor sees 60 points whose places are known. For 24 of them, it takes another point for this one.
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-5, 5);
  std::normal_distribution<double> noise(0, 0.01);  // meters
  const SE3 truth(Vector3(1, -2, 0.5), Eigen::Quaterniond(0.8, 0.2, -0.4, 0.4));
  Graph graph;
  const auto pose = graph.add_vertex(SE3());
  for (int k = 0; k < 60; ++k) {
    const Vector3 place(coordinate(random), coordinate(random), coordinate(random));
    const auto point = graph.add_vertex(place);
    graph.fix(point);
    const Vector3 wrong(coordinate(random), coordinate(random), coordinate(random));
    const Vector3 seen = truth.inverse() * (k % 5 < 2 ? wrong : place);
    const Vector3 measured = seen + Vector3(noise(random), noise(random), noise(random));
    graph.add_edge(PointObservation3(measured), Information(1e4), pose, point);
  }

  Graph trusting = graph;
  const Report least_squares = optimize(trusting);
  // [all]
  OutlierOptions options;
  options.suspects = Suspects::kAll;
  const OutlierReport found = find_outliers(graph, options);
  for (const EdgeVerdict& edge : found.verdicts) {
    if (edge.weight == 0) graph.remove(edge.edge);  // took no part
  }
  // [/all]

  const auto error = [&](const Graph& g) {
    return (g.estimate(pose).translation() - truth.translation()).norm();
  };
  std::printf("least squares: %.3f m from the truth\n", error(trusting));
  std::printf("without %zu false pairs: %.3f m\n", found.count(Verdict::kOutlier), error(graph));
  const bool ok = found.report.converged() && found.count(Verdict::kOutlier) == 24 && error(graph) < 0.01;
  return ok && least_squares.iterations > 0 ? 0 : 1;
}
