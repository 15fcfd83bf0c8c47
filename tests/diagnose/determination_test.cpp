// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/range.h"
#include "diagnose/findings.h"

namespace boxplus {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

TEST(DiagnoseDetermination, NamesTheDirectionThatNoEdgeOfAVertexMeasures) {
  HealthyCircle circle;
  const auto landmark = circle.graph.add_vertex(Vector2(3, 4), 100);
  circle.graph.add_edge([](const auto& x) { return x[0] - 3; }, landmark);
  circle.graph.add_edge([](const auto& x) { return x[0] - 3.1; }, landmark);
  const Finding finding = only(diagnose(circle.graph), Kind::kUndeterminedDirection);
  EXPECT_THAT(finding.ids, ElementsAre(100));
  EXPECT_THAT(finding.text, HasSubstr("the edges of point 100 do not determine y"));
  ASSERT_THAT(finding.directions, SizeIs(1));
  EXPECT_EQ(finding.directions[0].vertex, VertexRef(landmark));
  EXPECT_THAT(finding.directions[0].tangent, ElementsAre(DoubleNear(0, 1e-12), DoubleNear(1, 1e-12)));
}

TEST(DiagnoseDetermination, NamesTheRotationOfAPose) {
  Graph graph;
  const auto pose = graph.add_vertex(SE3(), 5);
  for (int k = 0; k < 2; ++k) {
    graph.add_edge(
        [](const auto& x) {
          const auto t = x.translation();
          const auto& q = x.quaternion();
          return Vector<std::remove_cvref_t<decltype(t[0])>, 5>(t[0], t[1], t[2], q.x, q.y);
        },
        pose);
  }
  EXPECT_THAT(only(diagnose(graph), Kind::kUndeterminedDirection).text,
              HasSubstr("the edges of pose 5 do not determine yaw"));
}

TEST(DiagnoseDetermination, GivesTheComponentsOfADirectionThatIsNoAxis) {
  Graph graph;
  const auto x = graph.add_vertex(Vector<double, 3>(1, 2, 3), 0);
  graph.add_edge([](const auto& v) { return v[0] + v[1]; }, x);
  graph.add_edge([](const auto& v) { return v[2]; }, x);
  const Finding finding = only(diagnose(graph), Kind::kUndeterminedDirection);
  ASSERT_THAT(finding.directions, SizeIs(1));
  EXPECT_NEAR(std::abs(finding.directions[0].tangent[0]), std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(finding.directions[0].tangent[0] + finding.directions[0].tangent[1], 0, 1e-9);
}

TEST(DiagnoseDetermination, AFixedDirectionIsDetermined) {
  Graph graph;
  const auto x = graph.add_vertex(Vector2(3, 4));
  graph.add_edge([](const auto& v) { return v[0] - 3; }, x);
  graph.fix_directions(x, {1});
  EXPECT_TRUE(diagnose(graph).ok()) << diagnose(graph);
}

TEST(DiagnoseDetermination, NamesAVertexWhoseJacobiansAreAllZero) {
  HealthyCircle circle;
  const auto point =
      circle.graph.add_vertex(Vector2(circle.graph.estimate(circle.poses[3]).translation()), 100);
  circle.graph.add_edge(Range(2), circle.poses[3], point);
  const Diagnosis diagnosis = diagnose(circle.graph);
  const Finding finding = only(diagnosis, Kind::kZeroJacobian);
  EXPECT_THAT(finding.ids, ElementsAre(100));
  EXPECT_EQ(finding.severity, Severity::kWarning);
  EXPECT_THAT(diagnosis, Not(HasFinding(Kind::kUndeterminedDirection)));
}

TEST(DiagnoseDetermination, NamesAPointThatIsSeenOnce) {
  HealthyCameras world;
  const auto point = world.graph.add_vertex(Vector3(1, 1, 8), 500);
  const auto edge = world.see(world.cameras[2], point);
  const Finding finding = only(diagnose(world.graph), Kind::kSeenOnce);
  EXPECT_THAT(finding.ids, ElementsAre(500));
  EXPECT_THAT(finding.edges, ElementsAre(EdgeRef(edge)));
  EXPECT_EQ(finding.severity, Severity::kWarning);
  const Vector3 ray = (Vector3(1, 1, 8) - world.graph.estimate(world.cameras[2]).translation()).normalized();
  ASSERT_THAT(finding.directions, SizeIs(1));
  EXPECT_NEAR(std::abs(ray.dot(Vector3(finding.directions[0].tangent.data()))), 1, 1e-6);
}

TEST(DiagnoseDetermination, APointThatAPoseMeasuresOnceIsDetermined) {
  HealthyCircle circle;
  const auto point = circle.graph.add_vertex(Vector2(3, 4), 100);
  circle.graph.add_edge(PointObservation2(Vector2(1, 1)), circle.poses[3], point);
  EXPECT_TRUE(diagnose(circle.graph).ok()) << diagnose(circle.graph);
}

}  // namespace
}  // namespace boxplus
