// SPDX-License-Identifier: BSD-3-Clause
// Finds the mixture of three materials that explains a measured spectrum. The shares of the materials have
// bounds, because they are not negative, and a constraint, because their sum is 1.
#include <boxplus/boxplus.h>
#include <boxplus/types/constraint.h>

#include <cmath>
#include <cstdio>
#include <limits>

using namespace boxplus;

/// The measured reflectance of the mixture in one band, and the reflectances of the pure materials there.
struct Band {
  Vector3 pure;
  double measured;

  template <class S>
  S error(const Vector<S, 3>& shares) const {
    return pure[0] * shares[0] + pure[1] * shares[1] + pure[2] * shares[2] - measured;
  }
};

int main() {
  Graph graph;
  // [limits]
  const auto shares = graph.add_vertex(Vector3(0.4, 0.3, 0.3));
  for (int i = 0; i < 3; ++i) graph.set_bounds(shares, i, 0, std::numeric_limits<double>::infinity());
  graph.add_edge(Constraint([](const auto& s) { return s[0] + s[1] + s[2] - 1.0; }), shares);
  // [/limits]
  // A mixture of 70 % of the first and 30 % of the second material. Noise suggests a negative share of the
  // third.
  const double noise[] = {0.008, -0.006, 0.011, -0.004, 0.009};
  for (int k = 0; k < 5; ++k) {
    const Vector3 pure(0.1 + 0.15 * k, 0.8 - 0.1 * k, 0.5 + 0.1 * (k % 2));
    graph.add_edge(Band{pure, 0.7 * pure[0] + 0.3 * pure[1] + noise[k]}, 1e4, shares);
  }
  const Report report = optimize(graph);
  const auto& s = graph.estimate(shares);
  std::printf("shares %.3f, %.3f, %.3f; sum %.9f\n", s[0], s[1], s[2], s.sum());
  // [multipliers]
  for (const Report::ActiveBound& bound : report.active_bounds)
    std::printf("share %d is at its limit; a limit that is lower by 0.01 would lower chi2 by about %.3f\n",
                bound.entry, 0.01 * bound.multiplier);
  // [/multipliers]
  const bool is_right = s.minCoeff() >= 0 && s[2] == 0 && std::abs(s.sum() - 1) < 1e-8 &&
                        report.active_bounds.size() == 1 && std::abs(s[0] - 0.7) < 0.05;
  return report.converged() && is_right ? 0 : 1;
}
