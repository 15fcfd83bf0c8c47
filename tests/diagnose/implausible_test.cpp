// SPDX-License-Identifier: BSD-3-Clause
#include "diagnose/findings.h"

namespace boxplus {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(DiagnoseImplausible, NamesACameraWithANegativeFocalLength) {
  Graph graph;
  graph.add_vertex(PinholeCamera(500.0, 500.0, 320.0, 240.0), 4);
  graph.add_vertex(PinholeCamera(500.0, -500.0, 320.0, 240.0), 5);
  const Finding finding = only(diagnose(graph), Kind::kImplausibleEstimate);
  EXPECT_EQ(finding.severity, Severity::kWarning);
  EXPECT_THAT(finding.ids, ElementsAre(5));
  EXPECT_THAT(finding.text,
              HasSubstr("vertex 5 cannot be right: fy is -500, but focal lengths are positive;"));
}

TEST(DiagnoseImplausible, NamesCamerasWithoutFocalLengthOrWithAbsurdDistortion) {
  Graph graph;
  graph.add_vertex(SimpleRadialCamera(500.0, 320.0, 240.0, 1000.0), 7);
  graph.add_vertex(SimpleRadialCamera(0.0, 320.0, 240.0, 0.1), 6);
  const Finding finding = only(diagnose(graph), Kind::kImplausibleEstimate);
  EXPECT_THAT(finding.ids, ElementsAre(6, 7));
  EXPECT_THAT(finding.text, HasSubstr("f is 0, but focal lengths are positive (that of 6)"));
}

TEST(DiagnoseImplausible, NamesTheIntrinsicsOfAPoseWithACamera) {
  Graph graph;
  graph.add_vertex(Product(SE3(), BalCamera(-500.0, 0.0, 0.0)), 3);
  EXPECT_THAT(only(diagnose(graph), Kind::kImplausibleEstimate).text,
              HasSubstr("pose 3 cannot be right: f is -500, but focal lengths are positive"));
}

/// A type of a user with a member implausible().
struct Temperature {
  static constexpr std::string_view kName = "Temperature";
  double kelvin = 0;
  std::string_view implausible() const { return kelvin < 0 ? "it is below 0 K" : ""; }
};

}  // namespace

template <>
struct Manifold<Temperature> {
  static constexpr int kDim = 1;
  static Temperature oplus(const Temperature& x, const double* delta) { return {x.kelvin + delta[0]}; }
  static void ominus(const Temperature& y, const Temperature& x, double* delta) {
    delta[0] = y.kelvin - x.kelvin;
  }
};

namespace {

TEST(DiagnoseImplausible, AsksTheTypesOfUsers) {
  Graph graph;
  graph.add_vertex(Temperature{300}, 1);
  EXPECT_THAT(diagnose(graph), Not(HasFinding(Kind::kImplausibleEstimate)));
  graph.add_vertex(Temperature{-3}, 2);
  const Finding finding = only(diagnose(graph), Kind::kImplausibleEstimate);
  EXPECT_THAT(finding.ids, ElementsAre(2));
  EXPECT_THAT(finding.text, HasSubstr("it is below 0 K"));
}

}  // namespace
}  // namespace boxplus
