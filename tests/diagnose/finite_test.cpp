// SPDX-License-Identifier: BSD-3-Clause
#include <limits>

#include "diagnose/findings.h"

namespace boxplus {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(DiagnoseFinite, NamesTheVertexWhoseEstimateIsNotFinite) {
  HealthyCircle circle;
  circle.graph.set_estimate(circle.poses[7], SE2(1, kNan, 0));
  const Diagnosis diagnosis = diagnose(circle.graph);
  const Finding finding = only(diagnosis, Kind::kNonFiniteEstimate);
  EXPECT_THAT(finding.ids, ElementsAre(7));
  EXPECT_EQ(finding.severity, Severity::kError);
  EXPECT_THAT(only(diagnosis, Kind::kNonFiniteError).edges, ElementsAre(circle.edge(6), circle.edge(7)));
  EXPECT_FALSE(diagnosis.at_minimum);
}

TEST(DiagnoseFinite, NamesTheEdgeWhoseErrorIsNotFinite) {
  HealthyCircle circle;
  const auto edge =
      circle.graph.add_edge([](const SE2& x) { return std::sqrt(-1 - x.x() * x.x()); }, circle.poses[4]);
  const Diagnosis diagnosis = diagnose(circle.graph);
  const Finding finding = only(diagnosis, Kind::kNonFiniteError);
  EXPECT_THAT(finding.edges, ElementsAre(EdgeRef(edge)));
  EXPECT_EQ(finding.severity, Severity::kError);
  EXPECT_THAT(diagnosis, Not(HasFinding(Kind::kNonFiniteEstimate)));
}

TEST(DiagnoseFinite, NamesAnEdgeWhoseChi2Overflows) {
  HealthyCircle circle;
  const auto edge = circle.graph.add_edge(Prior(SE2(1e200, 0, 0)), circle.poses[4]);
  EXPECT_THAT(only(diagnose(circle.graph), Kind::kNonFiniteError).edges, ElementsAre(EdgeRef(edge)));
}

/// An error whose Jacobian is not finite.
struct Steep {
  double error(const SE2& x) const { return x.x(); }
  template <class A>
  void jacobians(const SE2&, A& J) const {
    J.setConstant(std::numeric_limits<double>::infinity());
  }
};

TEST(DiagnoseFinite, NamesTheEdgeWhoseJacobianIsNotFinite) {
  HealthyCircle circle;
  const auto edge = circle.graph.add_edge(Steep{}, circle.poses[4]);
  const Diagnosis diagnosis = diagnose(circle.graph);
  const Finding finding = only(diagnosis, Kind::kNonFiniteJacobian);
  EXPECT_THAT(finding.edges, ElementsAre(EdgeRef(edge)));
  EXPECT_EQ(finding.severity, Severity::kError);
  EXPECT_THAT(finding.text, HasSubstr("of vertex 4"));
  EXPECT_THAT(diagnosis, Not(HasFinding(Kind::kNonFiniteError)));
}

}  // namespace
}  // namespace boxplus
