// SPDX-License-Identifier: BSD-3-Clause
#include "diagnose/findings.h"

namespace boxplus {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

TEST(DiagnoseWrongJacobian, NamesTheTypeAndTheEntry) {
  const Graph graph = chain_with_wrong_jacobian(-1);
  const Finding finding = only(diagnose(graph), Kind::kWrongJacobian);
  EXPECT_EQ(finding.severity, Severity::kError);
  EXPECT_THAT(finding.text,
              HasSubstr("jacobians() of Difference is wrong: ∂e/∂x_2, row 2, column 2 is -1 instead of 1"));
  EXPECT_GE(finding.edges.size(), 2u);
  ASSERT_THAT(finding.directions, SizeIs(1));
  EXPECT_THAT(finding.directions[0].tangent, ElementsAre(0, 1));
  EXPECT_EQ(finding.directions[0].vertex, graph.vertices(finding.edges.front())[1]);
}

TEST(DiagnoseWrongJacobian, FindsAnErrorOfOnePerMille) {
  EXPECT_THAT(diagnose(chain_with_wrong_jacobian(1.001)), HasFinding(Kind::kWrongJacobian));
}

TEST(DiagnoseWrongJacobian, FindsNothingIfTheJacobiansAreRight) {
  EXPECT_THAT(diagnose(chain_with_wrong_jacobian(1)), Not(HasFinding(Kind::kWrongJacobian)));
}

TEST(DiagnoseWrongJacobian, FindsNothingIfTheRunUsesNumericJacobians) {
  EXPECT_THAT(diagnose(chain_with_wrong_jacobian(-1), {.numeric_jacobians = true}),
              Not(HasFinding(Kind::kWrongJacobian)));
}

}  // namespace
}  // namespace boxplus
