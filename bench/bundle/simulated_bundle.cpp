// SPDX-License-Identifier: BSD-3-Clause
// simulated_bundle CAMERAS POINTS: simulates a street with 5 observations per point, optimizes it with one
// thread, and prints: observations, seconds of the plan, median seconds of an iteration, iterations, chi2 per
// degree of freedom, whether the run converged, and the peak memory of the process in MiB.
#include <fmt/core.h>

#include <exception>
#include <string>

#include "boxplus/optimize/optimizer.h"
#include "boxplus/testing/simulate_bundle.h"
#include "datasets/median_iteration.h"
#include "datasets/whole_run.h"

using namespace boxplus;

int main(int count, char** words) try {
  if (count != 3) throw InvalidArgument("expected CAMERAS POINTS");
  Graph graph =
      simulate_bundle(BundleShape::kStreet, {.cameras = std::stoi(words[1]), .points = std::stoi(words[2])})
          .graph;
  const Report report = optimize(graph, {.threads = 1});
  const double freedom = 2.0 * static_cast<double>(report.edges) - static_cast<double>(report.scalars);
  fmt::print("{} {} {} {} {} {} {}\n", report.edges, report.time.plan_s, bench::median_iteration(report),
             report.iterations, report.chi2_final / freedom, report.converged() ? "yes" : "no",
             bench::peak_mib());
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "simulated_bundle: {}\n", error.what());
  return 1;
}
