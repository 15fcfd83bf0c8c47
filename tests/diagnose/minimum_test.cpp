// SPDX-License-Identifier: BSD-3-Clause

#include <tuple>

#include "boxplus/robust/redescending.h"
#include "diagnose/findings.h"

namespace boxplus {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// A grid of poses with many loops, so that a single false edge cannot spread its error.
struct GridWithFalseEdge {
  Graph graph;
  EdgeRef edge;

  GridWithFalseEdge() {
    const auto poses = add_noisy_grid(graph, 4);
    graph.fix(poses.front());
    edge = graph.add_edge(Between(SE3(Vector3(5, 5, 5), SO3())), 2500.0, poses[3], poses[40]);
  }
};

TEST(DiagnoseMinimum, NamesAnOutlierAtTheMinimum) {
  GridWithFalseEdge grid;
  EXPECT_TRUE(optimize(grid.graph).converged());
  const Diagnosis diagnosis = diagnose(grid.graph);
  EXPECT_TRUE(diagnosis.at_minimum);
  const Finding finding = only(diagnosis, Kind::kOutlier);
  EXPECT_THAT(finding.edges, testing::Contains(grid.edge));
  EXPECT_EQ(finding.severity, Severity::kWarning);
  EXPECT_THAT(finding.text, HasSubstr("is that of the edge Between<SE3> of vertices 3, 40"));
}

TEST(DiagnoseMinimum, NamesOnlyTheOutlierIfARobustKernelRejectsIt) {
  GridWithFalseEdge grid;
  grid.graph.set_kernel(grid.edge, Tukey(4));
  std::ignore = optimize(grid.graph);
  EXPECT_THAT(only(diagnose(grid.graph), Kind::kOutlier).edges, ElementsAre(grid.edge));
}

TEST(DiagnoseMinimum, DoesNotJudgeErrorsAwayFromAMinimum) {
  GridWithFalseEdge grid;
  const Diagnosis diagnosis = diagnose(grid.graph);
  EXPECT_FALSE(diagnosis.at_minimum);
  EXPECT_THAT(diagnosis, Not(HasFinding(Kind::kOutlier)));
  const Finding finding = only(diagnosis, Kind::kNotAtMinimum);
  EXPECT_EQ(finding.severity, Severity::kNote);
  EXPECT_THAT(finding.text, HasSubstr("only after a run"));
}

TEST(DiagnoseMinimum, MayBeAtALimit) {
  Graph graph;
  const auto point = graph.add_vertex(Vector2(0.5, 0));
  graph.add_edge(Prior(Vector2(3, -2)), 100.0, point);
  graph.set_bounds(point, 0, -1, 1);
  EXPECT_FALSE(diagnose(graph).at_minimum);
  EXPECT_TRUE(optimize(graph).converged());
  EXPECT_EQ(graph.estimate(point)[0], 1);
  EXPECT_TRUE(diagnose(graph).at_minimum);
  graph.set_bounds(point, 0, -1, 2);  // wider, so that the point can move on
  EXPECT_FALSE(diagnose(graph).at_minimum);
}

TEST(DiagnoseMinimum, SaysWhetherInformationIsTooLargeOrTooSmall) {
  for (const double factor : {1e-2, 1e2}) {
    Graph graph;
    const auto poses = add_noisy_grid(graph, 4);
    for (const EdgeRef& edge : graph.all_edges()) graph.set_information(edge, 2500 * factor);
    EXPECT_TRUE(optimize(graph).converged());
    const Finding finding = only(diagnose(graph), Kind::kChi2Ratio);
    EXPECT_EQ(finding.severity, Severity::kNote);
    EXPECT_THAT(finding.text, HasSubstr(factor > 1 ? "Ω is too large" : "Ω is too small"));
    EXPECT_THAT(finding.text, HasSubstr("at a minimum"));
  }
}

TEST(DiagnoseMinimum, CountsTheDegreesOfFreedomOfTheReport) {
  Graph graph;
  add_noisy_grid(graph, 3);
  for (const EdgeRef& edge : graph.all_edges()) graph.set_information(edge, 25.0);
  const Report report = optimize(graph);
  EXPECT_THAT(only(diagnose(graph), Kind::kChi2Ratio).text,
              HasSubstr("degrees of freedom (" + std::to_string(report.degrees_of_freedom) + ")"));
}

}  // namespace
}  // namespace boxplus
