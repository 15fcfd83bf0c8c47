// SPDX-License-Identifier: BSD-3-Clause
// Outliers: fits a curve y = exp(m t + c) to samples. Every fifth sample is grossly wrong.
//
// Least squares trusts every measurement, so a few wrong measurements pull the curve away from the correct
// measurements. A robust kernel gives an edge less weight if the error of the edge is large. The width of the
// kernel is roughly the error, in standard deviations, at which the weight starts to decrease.
#include <boxplus/boxplus.h>
#include <boxplus/robust/default_width.h>
#include <boxplus/robust/redescending.h>

#include <cmath>
#include <cstdio>
#include <vector>

using namespace boxplus;

/// One sample of the curve. The vertex of the edge contains (m, c).
struct Sample {
  double t, y;

  template <class S>
  S error(const Vector<S, 2>& curve) const {
    using std::exp;
    return exp(curve[0] * t + curve[1]) - y;
  }
};

int main() {
  const Vector2 truth(0.3, 0.1);
  Graph graph;
  const auto curve = graph.add_vertex(Vector2(0, 0));
  const double sigma = 0.05;
  std::vector<EdgeHandle<Sample>> samples;
  for (int i = 0; i < 50; ++i) {
    const double t = 0.1 * i, noise = sigma * std::sin(37.0 * i);
    const double outlier = i % 5 == 0 ? 4 : 0;
    const Sample sample{t, std::exp(truth[0] * t + truth[1]) + noise + outlier};
    samples.push_back(graph.add_edge(sample, 1 / (sigma * sigma), curve));
  }

  if (!optimize(graph).converged()) return 1;
  const Vector2 trusting = graph.estimate(curve);
  std::printf("least squares:  m %.3f, c %.3f\n", trusting[0], trusting[1]);

  // [kernel]
  for (const auto& sample : samples)
    graph.set_kernel(sample, Cauchy(default_width(1)));  // the width for errors with one row
  const Report report = optimize(graph);
  // [/kernel]
  const Vector2 robust = graph.estimate(curve);
  std::printf("Cauchy kernel:  m %.3f, c %.3f (the truth: %.3f, %.3f)\n", robust[0], robust[1], truth[0],
              truth[1]);

  const bool helps = (robust - truth).norm() < 0.02 && (trusting - truth).norm() > 0.2;
  return report.converged() && helps ? 0 : 1;
}
