// SPDX-License-Identifier: BSD-3-Clause
#include "diagnose/findings.h"

namespace boxplus {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(DiagnoseInformation, NamesAnEdgeWhoseInformationIsZero) {
  HealthyCircle circle;
  circle.graph.set_information(circle.edge(5), 0.0);
  const Finding finding = only(diagnose(circle.graph), Kind::kZeroInformation);
  EXPECT_THAT(finding.edges, ElementsAre(circle.edge(5)));
  EXPECT_EQ(finding.severity, Severity::kWarning);
  EXPECT_THAT(finding.text, HasSubstr("the Ω of the edge Between<SE2> of vertices 5, 6 is zero"));
}

TEST(DiagnoseInformation, NamesTheRowWhoseUnitsDifferFromThoseOfTheOtherEdges) {
  HealthyCircle circle;
  for (const std::size_t k : {5u, 9u})  // radians instead of milliradians, or the other way round
    circle.graph.set_information(circle.edge(k), Information::diagonal(std::vector{400.0, 400.0, 9e8}));
  const Finding finding = only(diagnose(circle.graph), Kind::kMixedUnits);
  EXPECT_THAT(finding.edges, ElementsAre(circle.edge(5), circle.edge(9)));
  EXPECT_EQ(finding.severity, Severity::kWarning);
  EXPECT_THAT(finding.text, HasSubstr("1e+06 times as large as usual for Between<SE2> (row 3"));
}

TEST(DiagnoseInformation, NamesInformationThatIsTooSmall) {
  HealthyCircle circle;
  circle.graph.set_information(circle.edge(5), Information::diagonal(std::vector{4e-4, 4e-4, 900.0}));
  const Finding finding = only(diagnose(circle.graph), Kind::kMixedUnits);
  EXPECT_THAT(finding.edges, ElementsAre(circle.edge(5)));
  EXPECT_THAT(finding.text, HasSubstr("1e+06 times smaller than usual"));
}

TEST(DiagnoseInformation, StandardDeviationsMayDifferByTwoOrdersOfMagnitude) {
  HealthyCircle circle;
  circle.graph.set_information(circle.edge(5), 4e6);
  EXPECT_THAT(diagnose(circle.graph), Not(HasFinding(Kind::kMixedUnits)));
}

}  // namespace
}  // namespace boxplus
