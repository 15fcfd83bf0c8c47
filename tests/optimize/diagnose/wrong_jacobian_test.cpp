// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/diagnose/findings.h"

namespace boxplus {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

/// The difference of two points. Some entries of the Jacobian by the second point are multiplied by `factor`.
struct Difference {
  static constexpr std::string_view kName = "Difference";
  Vector2 measurement;
  double factor = 1;

  template <class S>
  Vector<S, 2> error(const Vector<S, 2>& a, const Vector<S, 2>& b) const {
    return b - a - measurement.template cast<S>();
  }
  template <class A, class B>
  void jacobians(const Vector2&, const Vector2&, A& J_a, B& J_b) const {
    J_a = -Eigen::Matrix2d::Identity();
    J_b = Eigen::Matrix2d::Identity();
    J_b(1, 1) *= factor;
  }
};

Graph chain(double factor) {
  Graph graph;
  std::vector<VertexHandle<Vector2>> points{graph.add_vertex(Vector2(0, 0))};
  graph.fix(points.front());
  for (int k = 0; k < 20; ++k) {
    points.push_back(graph.add_vertex(Vector2(k + 1, 0.5 * k)));
    graph.add_edge(Difference{Vector2(1, 0.5), factor}, points[points.size() - 2], points.back());
  }
  return graph;
}

TEST(DiagnoseWrongJacobian, NamesTheTypeAndTheEntry) {
  const Graph graph = chain(-1);
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
  EXPECT_THAT(diagnose(chain(1.001)), HasFinding(Kind::kWrongJacobian));
}

TEST(DiagnoseWrongJacobian, FindsNothingIfTheJacobiansAreRight) {
  EXPECT_THAT(diagnose(chain(1)), Not(HasFinding(Kind::kWrongJacobian)));
}

TEST(DiagnoseWrongJacobian, FindsNothingIfTheRunUsesNumericJacobians) {
  EXPECT_THAT(diagnose(chain(-1), {.numeric_jacobians = true}), Not(HasFinding(Kind::kWrongJacobian)));
}

}  // namespace
}  // namespace boxplus
