// SPDX-License-Identifier: BSD-3-Clause
#include "diagnose/findings.h"

namespace boxplus {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(DiagnoseStructure, NamesVerticesWithoutEdges) {
  HealthyCircle circle;
  circle.graph.add_vertex(SE2(), 500);
  circle.graph.add_vertex(Vector2(1, 1), 450);
  circle.graph.add_parameter(SE2());
  circle.graph.fix(circle.graph.add_vertex(SE2(), 600));
  const Finding finding = only(diagnose(circle.graph), Kind::kIsolatedVertex);
  EXPECT_THAT(finding.ids, ElementsAre(450, 500));
  EXPECT_EQ(circle.graph.id(finding.vertices[1]), 500);
  EXPECT_EQ(finding.severity, Severity::kWarning);
  EXPECT_THAT(finding.text, HasSubstr("vertices 450, 500 have no edge"));
}

TEST(DiagnoseStructure, AVertexWhoseEdgesAreDisabledHasNoEdge) {
  HealthyCircle circle;
  const auto pose = circle.graph.add_vertex(SE2(), 500);
  circle.graph.set_enabled(circle.graph.add_edge(Prior(SE2()), pose), false);
  EXPECT_THAT(only(diagnose(circle.graph), Kind::kIsolatedVertex).ids, ElementsAre(500));
}

TEST(DiagnoseStructure, SaysThatAllVerticesAreFixed) {
  HealthyCircle circle(5);
  for (const auto& pose : circle.poses) circle.graph.fix(pose);
  const Diagnosis diagnosis = diagnose(circle.graph);
  const Finding finding = only(diagnosis, Kind::kNothingMoves);
  EXPECT_EQ(finding.severity, Severity::kError);
  EXPECT_THAT(finding.ids, ElementsAre(0, 1, 2, 3, 4));
  EXPECT_EQ(diagnosis.findings.size(), 1u) << diagnosis;
}

TEST(DiagnoseStructure, NamesEdgesBetweenFixedVertices) {
  HealthyCircle circle;
  circle.graph.fix(circle.poses[1]);
  const Finding finding = only(diagnose(circle.graph), Kind::kFixedEdge);
  EXPECT_THAT(finding.edges, ElementsAre(circle.edge(0)));
  EXPECT_EQ(finding.severity, Severity::kNote);
  EXPECT_THAT(finding.text, HasSubstr("Between<SE2> of vertices 0, 1"));
}

TEST(DiagnoseStructure, NamesAnEdgeThatRepeatsAnEarlierOne) {
  HealthyCircle circle;
  const EdgeHandle<Between<SE2>> original{circle.edge(7)};
  const auto copy =
      circle.graph.add_edge(circle.graph.measurement(original), 400.0, circle.poses[7], circle.poses[8]);
  const Finding finding = only(diagnose(circle.graph), Kind::kDuplicateEdge);
  EXPECT_THAT(finding.edges, ElementsAre(EdgeRef(copy)));
  EXPECT_EQ(finding.severity, Severity::kWarning);
}

TEST(DiagnoseStructure, OneDuplicateAmongHundredsOfEdgesIsANote) {
  HealthyCircle circle(300);
  const EdgeHandle<Between<SE2>> original{circle.edge(7)};
  circle.graph.add_edge(circle.graph.measurement(original), 400.0, circle.poses[7], circle.poses[8]);
  EXPECT_EQ(only(diagnose(circle.graph), Kind::kDuplicateEdge).severity, Severity::kNote);
}

TEST(DiagnoseStructure, DifferentMeasurementsOfTheSameVerticesAreNoDuplicates) {
  HealthyCircle circle;
  const EdgeHandle<Between<SE2>> original{circle.edge(7)};
  const SE2 z = circle.graph.measurement(original).measurement * SE2(1e-9, 0, 0);
  circle.graph.add_edge(Between(z), 400.0, circle.poses[7], circle.poses[8]);
  EXPECT_THAT(diagnose(circle.graph), Not(HasFinding(Kind::kDuplicateEdge)));
}

TEST(DiagnoseStructure, ErrorsThatDoNotDependOnTheVerticesAreNoDuplicates) {
  Graph graph;
  const auto x = graph.add_vertex(Vector2(1, 1));
  graph.add_edge(Prior(Vector2(1, 1)), x);
  for (const double bound : {3.0, 5.0})  // limits that do not act
    graph.add_edge([bound](const Vector2& v) { return std::max(0.0, v[0] - bound); }, x);
  EXPECT_THAT(diagnose(graph), Not(HasFinding(Kind::kDuplicateEdge)));
}

}  // namespace
}  // namespace boxplus
