// SPDX-License-Identifier: BSD-3-Clause
#include "diagnose/findings.h"

namespace boxplus {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(DiagnoseDominant, NotesTheCameraWhoseEdgesHaveMostOfChi2BeforeARun) {
  HealthyCameras world;
  world.graph.set_estimate(world.cameras[3], SE3(Vector3(3, 3, 1), SO3()));
  const Finding finding = only(diagnose(world.graph), Kind::kDominantVertex);
  EXPECT_EQ(finding.severity, Severity::kNote);
  EXPECT_THAT(finding.ids, ElementsAre(world.graph.id(world.cameras[3])));
  EXPECT_THAT(finding.text, HasSubstr("the 12 edges of pose 3 (25 % of all) have 99 % of chi2"));
}

TEST(DiagnoseDominant, WarnsOfAVertexWhoseMeasurementsContradictEachOtherAtAMinimum) {
  Graph graph;
  for (int k = 0; k < 20; ++k) graph.add_edge(Prior(Vector2(k, 0)), 1.0, graph.add_vertex(Vector2(k, 0)));
  const auto point = graph.vertex<Vector2>(5);
  for (const double x : {-90.0, 90.0}) {
    for (const double y : {-90.0, 90.0}) graph.add_edge(Prior(Vector2(5 + x, y)), 1.0, point);
  }
  const Diagnosis diagnosis = diagnose(graph);
  ASSERT_TRUE(diagnosis.at_minimum);
  const Finding finding = only(diagnosis, Kind::kDominantVertex);
  EXPECT_EQ(finding.severity, Severity::kWarning);
  EXPECT_THAT(finding.ids, ElementsAre(5));
}

TEST(DiagnoseDominant, ASingleWrongEdgeIsAnOutlierAndNoFaultOfItsVertices) {
  HealthyCameras world;
  world.graph.set_estimate(world.points[4], Vector3(0, 0, 10));
  world.graph.set_fixed(world.points[4], true);
  const auto edge = world.see(world.cameras[2], world.points[4]);
  world.graph.set_measurement(edge, CalibratedReprojection<PinholeCamera>(
                                        Vector2(9000, 0), PinholeCamera(500.0, 500.0, 320.0, 240.0)));
  EXPECT_THAT(diagnose(world.graph), Not(HasFinding(Kind::kDominantVertex)));
}

}  // namespace
}  // namespace boxplus
