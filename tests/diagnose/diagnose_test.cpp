// SPDX-License-Identifier: BSD-3-Clause
// The diagnosis as a whole. Each kind of finding has its tests in the file of its topic.
#include "boxplus/diagnose/diagnose.h"

#include <algorithm>
#include <atomic>
#include <limits>

#include "boxplus/testing/simulate_bundle.h"
#include "diagnose/finding_table.h"
#include "diagnose/findings.h"

namespace boxplus {
namespace {

TEST(Diagnose, FindsNothingInAHealthyGraphAtItsMinimum) {
  const HealthyCircle circle;
  const Diagnosis diagnosis = diagnose(circle.graph);
  EXPECT_TRUE(diagnosis.findings.empty()) << diagnosis;
  EXPECT_TRUE(diagnosis.ok());
  EXPECT_TRUE(diagnosis.at_minimum);
  EXPECT_TRUE(diagnosis.is_complete);
}

TEST(Diagnose, GivesOnlyNotesForHealthyGraphsBeforeARun) {
  Graph circle, grid;
  add_noisy_circle(circle, 40);
  add_noisy_grid(grid, 4);
  EXPECT_TRUE(diagnose(circle).ok()) << diagnose(circle);
  EXPECT_TRUE(diagnose(grid).ok()) << diagnose(grid);
  HealthyCameras cameras;
  EXPECT_TRUE(diagnose(cameras.graph).ok()) << diagnose(cameras.graph);
}

TEST(Diagnose, GivesOnlyNotesForSimulatedBundleAdjustmentBeforeAndAfterARun) {
  BundleSimulation bundle = simulate_bundle(BundleShape::kRing, {.cameras = 20, .points = 400});
  EXPECT_TRUE(diagnose(bundle.graph).ok()) << diagnose(bundle.graph);
  EXPECT_TRUE(optimize(bundle.graph).converged());
  const Diagnosis diagnosis = diagnose(bundle.graph);
  EXPECT_TRUE(diagnosis.ok()) << diagnosis;
  EXPECT_TRUE(diagnosis.at_minimum) << diagnosis;
}

TEST(Diagnose, ListsErrorsFirstThenWarningsThenNotes) {
  HealthyCircle circle;
  circle.graph.set_estimate(circle.poses[3], SE2(std::numeric_limits<double>::quiet_NaN(), 0, 0));
  circle.graph.add_vertex(SE2());
  circle.graph.fix(circle.poses[20]);
  circle.graph.fix(circle.poses[21]);
  const Diagnosis diagnosis = diagnose(circle.graph);
  EXPECT_GE(diagnosis.count(Severity::kError), 1u);
  EXPECT_EQ(diagnosis.count(Severity::kWarning), 1u);
  EXPECT_EQ(diagnosis.count(Severity::kNote), 1u);
  EXPECT_TRUE(std::is_sorted(diagnosis.findings.begin(), diagnosis.findings.end(),
                             [](const Finding& a, const Finding& b) { return a.severity > b.severity; }));
  EXPECT_FALSE(diagnosis.ok());
}

TEST(Diagnose, ChangesNothing) {
  HealthyCircle circle;
  const double chi2 = circle.graph.chi2();
  std::ignore = diagnose(circle.graph);
  EXPECT_EQ(circle.graph.chi2(), chi2);
}

TEST(Diagnose, ExaminesOnlyTheEdgesThatTakePart) {
  HealthyCircle circle;
  const auto other = circle.graph.add_edge(Between(SE2(std::numeric_limits<double>::quiet_NaN(), 0, 0)),
                                           circle.poses[3], circle.poses[9]);
  circle.graph.set_level(other, 1);
  EXPECT_TRUE(diagnose(circle.graph).ok());
  EXPECT_FALSE(diagnose(circle.graph, {.level = 1}).ok());
  circle.graph.set_level(other, 0);
  circle.graph.set_enabled(other, false);
  EXPECT_TRUE(diagnose(circle.graph).ok());
}

TEST(Diagnose, EndsWhenItsFlagIsRaised) {
  const HealthyCircle circle;
  const std::atomic<bool> stop = true;
  EXPECT_FALSE(diagnose(circle.graph, {.stop = &stop}).is_complete);
  EXPECT_FALSE(diagnose(circle.graph, {.time_limit_s = 0}).is_complete);
}

TEST(Diagnose, AcceptsAnEmptyGraph) {
  EXPECT_TRUE(diagnose(Graph()).findings.empty());
}

TEST(Diagnose, HasOneNamePerKind) {
  std::vector<std::string_view> names;
  for (const FindingEntry& entry : finding_table()) {
    EXPECT_EQ(to_string(entry.kind), entry.name);
    names.push_back(entry.name);
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}

TEST(Diagnose, PrintsOneLinePerFinding) {
  HealthyCircle circle;
  circle.graph.add_vertex(SE2(), 77);
  EXPECT_EQ(
      to_string(diagnose(circle.graph)),
      "warning: pose 77 has no edge that takes part, so optimize() leaves it alone: add an edge, or remove "
      "it [isolated-vertex]\n");
}

}  // namespace
}  // namespace boxplus
