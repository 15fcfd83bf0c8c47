// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/position_prior.h"
#include "boxplus/types/slam2d/bearing_observation.h"
#include "diagnose/findings.h"

namespace boxplus {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;
using DirectionKind = Finding::Direction::Kind;

std::vector<DirectionKind> kinds_of(const Finding& finding) {
  std::vector<DirectionKind> kinds;
  for (const Finding::Direction& direction : finding.directions) kinds.push_back(direction.kind);
  return kinds;
}

TEST(DiagnoseComponents, NotesThatNothingTiesAGraphToTheWorld) {
  Graph graph;
  add_noisy_circle(graph, 20);
  const Finding finding = only(diagnose(graph), Kind::kFreeComponent);
  EXPECT_EQ(finding.severity, Severity::kNote);
  EXPECT_THAT(finding.text, HasSubstr("poses 0…19 are free in x, y and yaw"));
  EXPECT_THAT(finding.ids, SizeIs(20));
  EXPECT_THAT(kinds_of(finding),
              ElementsAre(DirectionKind::kAlong, DirectionKind::kAlong, DirectionKind::kAbout));
}

TEST(DiagnoseComponents, NamesTheSixDirectionsOfSpace) {
  Graph graph;
  add_noisy_grid(graph, 2);
  EXPECT_THAT(only(diagnose(graph), Kind::kFreeComponent).text,
              HasSubstr("poses 0…7 are free in x, y, z, roll, pitch and yaw"));
}

TEST(DiagnoseComponents, WarnsOfAPartWithoutAnEdgeToTheRest) {
  HealthyCircle circle;
  const auto lost = add_noisy_circle(circle.graph, 12);
  const Finding finding = only(diagnose(circle.graph), Kind::kFreeComponent);
  EXPECT_EQ(finding.severity, Severity::kWarning);
  EXPECT_EQ(finding.ids.front(), circle.graph.id(lost.front()));
  EXPECT_THAT(finding.ids, SizeIs(12));
  EXPECT_THAT(finding.text, HasSubstr("poses 40…51 are free in x, y and yaw, because no edge joins them"));
}

TEST(DiagnoseComponents, WarnsOnlyOfTheSmallerPartIfNothingIsFixed) {
  Graph graph;
  add_noisy_circle(graph, 12);
  add_noisy_circle(graph, 20);
  std::vector<Severity> severities;
  for (const Finding& finding : diagnose(graph).findings) {
    if (finding.kind == Kind::kFreeComponent) severities.push_back(finding.severity);
  }
  EXPECT_THAT(severities, ElementsAre(Severity::kWarning, Severity::kNote));
}

TEST(DiagnoseComponents, SaysWhichRotationAPositionPriorLeavesFree) {
  Graph graph;
  const auto poses = add_noisy_circle(graph, 20);
  graph.add_edge(PositionPrior(Vector2(10, -3)), 1e4, poses[7]);
  const Finding finding = only(diagnose(graph), Kind::kFreeComponent);
  EXPECT_EQ(finding.severity, Severity::kWarning);
  EXPECT_THAT(finding.text, HasSubstr("are free in yaw, although a prior"));
  EXPECT_THAT(kinds_of(finding), ElementsAre(DirectionKind::kAbout));
  EXPECT_THAT(finding.directions.front().axis, ElementsAre(0, 0, 1));
}

TEST(DiagnoseComponents, NamesTheAxisThatTwoPositionPriorsLeaveFree) {
  Graph graph;
  const auto poses = add_noisy_grid(graph, 2);
  graph.add_edge(PositionPrior(Vector3(graph.estimate(poses[0]).translation())), poses[0]);
  graph.add_edge(PositionPrior(Vector3(graph.estimate(poses[1]).translation())), poses[1]);
  const Finding finding = only(diagnose(graph), Kind::kFreeComponent);
  ASSERT_THAT(kinds_of(finding), ElementsAre(DirectionKind::kAbout));
  const Vector3 axis =
      (graph.estimate(poses[1]).translation() - graph.estimate(poses[0]).translation()).normalized();
  EXPECT_NEAR(std::abs(axis.dot(Vector3(finding.directions.front().axis.data()))), 1, 1e-6);
  EXPECT_THAT(finding.text, HasSubstr("free about ("));
}

TEST(DiagnoseComponents, NamesTheTranslationThatNoEdgeMeasures) {
  // The edges measure differences of positions, and one of them x only.
  Graph graph;
  const auto a = graph.add_vertex(Vector2(0, 0)), b = graph.add_vertex(Vector2(1, 2));
  graph.add_edge([](const auto& x, const auto& y) { return (y - x).eval(); }, a, b);
  graph.add_edge([](const auto& x) { return x[0]; }, a);
  const Finding finding = only(diagnose(graph), Kind::kFreeComponent);
  EXPECT_THAT(finding.text, HasSubstr("points 0, 1 are free in y, although"));
  EXPECT_THAT(finding.directions.front().axis, ElementsAre(0, 1, 0));
}

TEST(DiagnoseComponents, NotesThatTheScaleIsFree) {
  // Bearings measure no length.
  Graph graph;
  const auto a = graph.add_vertex(SE2(0, 0, 0)), b = graph.add_vertex(SE2(4, 0, 0.3));
  graph.fix(a);
  for (int k = 0; k < 6; ++k) {
    const auto point = graph.add_vertex(Vector2(k, 3 + std::sin(k)));
    for (const auto& pose : {a, b}) {
      const Vector2 local = graph.estimate(pose).inverse_times(graph.estimate(point));
      graph.add_edge(BearingObservation2(std::atan2(local[1], local[0])), pose, point);
    }
  }
  const Finding finding = only(diagnose(graph), Kind::kFreeComponent);
  EXPECT_EQ(finding.severity, Severity::kNote);
  EXPECT_THAT(finding.text, HasSubstr("free in scale"));
  EXPECT_THAT(kinds_of(finding), ElementsAre(DirectionKind::kScale));
}

TEST(DiagnoseComponents, LeavesAFreedomToTheFindingsOfSingleVertices) {
  HealthyCircle circle;
  const auto landmark = circle.graph.add_vertex(Vector2(3, 4));
  circle.graph.add_edge(BearingObservation2(0.3), circle.poses[0], landmark);
  const Diagnosis diagnosis = diagnose(circle.graph);
  EXPECT_THAT(diagnosis, HasFinding(Kind::kSeenOnce));
  EXPECT_THAT(diagnosis, Not(HasFinding(Kind::kFreeComponent)));
}

TEST(DiagnoseComponents, FindsNothingIfEachPartIsFixed) {
  Graph graph;
  graph.fix(add_noisy_circle(graph, 12)[3]);
  graph.add_edge(Prior(SE2()), add_noisy_circle(graph, 12)[3]);
  EXPECT_THAT(diagnose(graph), Not(HasFinding(Kind::kFreeComponent)));
}

}  // namespace
}  // namespace boxplus
