// SPDX-License-Identifier: BSD-3-Clause
// 25 defects that people plant into graphs by mistake. The diagnosis names the right vertices or edges, and
// the direction, of each.
#include <functional>
#include <limits>
#include <string>

#include "boxplus/types/position_prior.h"
#include "boxplus/types/range.h"
#include "boxplus/types/slam2d/bearing_observation.h"
#include "diagnose/findings.h"

namespace boxplus {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::IsSupersetOf;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// What a finding must name.
struct Expected {
  Graph graph;
  Kind kind;
  std::vector<VertexRef> vertices = {};
  std::vector<EdgeRef> edges = {};
  std::string words = {};  ///< the direction, the entry or the factor
};

struct Defect {
  std::string name;
  std::function<Expected()> plant;
};

Expected wrong_jacobian(double factor, const std::string& words) {
  Graph graph = chain_with_wrong_jacobian(factor);
  const std::vector<EdgeRef> first{graph.all_edges().front()};
  return {.graph = std::move(graph), .kind = Kind::kWrongJacobian, .edges = first, .words = words};
}

/// An error whose Jacobian is not finite.
struct Steep {
  double error(const SE2& x) const { return x.x(); }
  template <class A>
  void jacobians(const SE2&, A& J) const {
    J.setConstant(std::numeric_limits<double>::infinity());
  }
};

/// Three poses in a column, whose position is known, and whose heading is not.
Expected poses_without_yaw() {
  Graph graph;
  const auto pose = graph.add_vertex(SE3(), 5);
  const auto level = [](const auto& x) {
    const auto t = x.translation();
    const auto& q = x.quaternion();
    return Vector<std::remove_cvref_t<decltype(t[0])>, 5>(t[0], t[1], t[2], q.x, q.y);
  };
  for (int k = 0; k < 2; ++k) graph.add_edge(level, pose);
  return {.graph = std::move(graph),
          .kind = Kind::kUndeterminedDirection,
          .vertices = {pose},
          .words = "do not determine yaw"};
}

Expected two_position_priors() {
  Graph graph;
  const auto poses = add_noisy_grid(graph, 2);
  for (const std::size_t k : {0u, 1u})
    graph.add_edge(PositionPrior(Vector3(graph.estimate(poses[k]).translation())), poses[k]);
  return {.graph = std::move(graph),
          .kind = Kind::kFreeComponent,
          .vertices = {poses[3]},
          .words = "are free about ("};
}

Expected false_edge_in_a_grid() {
  Graph graph;
  const auto poses = add_noisy_grid(graph, 4);
  graph.fix(poses.front());
  const EdgeRef edge = graph.add_edge(Between(SE3(Vector3(5, 5, 5), SO3())), 2500.0, poses[3], poses[40]);
  EXPECT_TRUE(optimize(graph).converged());
  return {.graph = std::move(graph), .kind = Kind::kOutlier, .edges = {edge}, .words = "of vertices 3, 40"};
}

Expected information_too_large_everywhere() {
  Graph graph;
  add_noisy_grid(graph, 4);
  for (const EdgeRef& edge : graph.all_edges()) graph.set_information(edge, 2.5e5);
  EXPECT_TRUE(optimize(graph).converged());
  return {.graph = std::move(graph), .kind = Kind::kChi2Ratio, .words = "Ω is too large"};
}

/// Spoils a circle of 40 poses at its minimum.
std::function<Expected()> in_circle(std::function<void(HealthyCircle&, Expected&)> spoil, Kind kind) {
  return [spoil = std::move(spoil), kind] {
    HealthyCircle circle;
    Expected expected{.graph = {}, .kind = kind};
    spoil(circle, expected);
    expected.graph = std::move(circle.graph);
    return expected;
  };
}

/// Spoils four cameras that see twelve points.
std::function<Expected()> in_cameras(std::function<void(HealthyCameras&, Expected&)> spoil, Kind kind) {
  return [spoil = std::move(spoil), kind] {
    HealthyCameras world;
    Expected expected{.graph = {}, .kind = kind};
    spoil(world, expected);
    expected.graph = std::move(world.graph);
    return expected;
  };
}

std::vector<Defect> defects() {
  using Circle = HealthyCircle;
  using World = HealthyCameras;
  return {
      {"EstimateIsNan", in_circle(
                            [](Circle& c, Expected& e) {
                              c.graph.set_estimate(c.poses[7], SE2(1, kNan, 0));
                              e.vertices = {c.poses[7]};
                            },
                            Kind::kNonFiniteEstimate)},
      {"ErrorIsNan", in_circle(
                         [](Circle& c, Expected& e) {
                           e.edges = {c.graph.add_edge(
                               [](const SE2& x) { return std::sqrt(-1 - x.x() * x.x()); }, c.poses[4])};
                         },
                         Kind::kNonFiniteError)},
      {"Chi2Overflows",
       in_circle(
           [](Circle& c, Expected& e) { e.edges = {c.graph.add_edge(Prior(SE2(1e200, 0, 0)), c.poses[4])}; },
           Kind::kNonFiniteError)},
      {"JacobianIsInfinite", in_circle(
                                 [](Circle& c, Expected& e) {
                                   e.edges = {c.graph.add_edge(Steep{}, c.poses[4])};
                                   e.words = "of vertex 4";
                                 },
                                 Kind::kNonFiniteJacobian)},
      {"AllVerticesAreFixed", in_circle(
                                  [](Circle& c, Expected& e) {
                                    for (const auto& pose : c.poses) c.graph.fix(pose);
                                    e.vertices = {c.poses[0], c.poses[39]};
                                  },
                                  Kind::kNothingMoves)},
      {"JacobianHasAWrongSign",
       [] { return wrong_jacobian(-1, "∂e/∂x_2, row 2, column 2 is -1 instead of 1"); }},
      {"JacobianIsSlightlyWrong", [] { return wrong_jacobian(1.01, "∂e/∂x_2, row 2, column 2 is 1.01"); }},
      {"VertexWithoutEdges",
       in_circle([](Circle& c, Expected& e) { e.vertices = {c.graph.add_vertex(SE2(), 500)}; },
                 Kind::kIsolatedVertex)},
      {"VertexWhoseEdgesAreDisabled", in_circle(
                                          [](Circle& c, Expected& e) {
                                            const auto pose = c.graph.add_vertex(SE2(), 500);
                                            c.graph.set_enabled(c.graph.add_edge(Prior(SE2()), pose), false);
                                            e.vertices = {pose};
                                          },
                                          Kind::kIsolatedVertex)},
      {"PartIsNotJoined", in_circle(
                              [](Circle& c, Expected& e) {
                                const auto lost = add_noisy_circle(c.graph, 12);
                                e.vertices = {lost.front(), lost.back()};
                                e.words = "free in x, y and yaw, because no edge joins them";
                              },
                              Kind::kFreeComponent)},
      {"PositionPriorLeavesYawFree", in_circle(
                                         [](Circle& c, Expected& e) {
                                           c.graph.unfix(c.poses.front());
                                           c.graph.add_edge(PositionPrior(Vector2(10, -3)), 1e4, c.poses[7]);
                                           e.vertices = {c.poses[0]};
                                           e.words = "are free in yaw, although a prior";
                                         },
                                         Kind::kFreeComponent)},
      {"TwoPositionPriorsLeaveAnAxisFree", two_position_priors},
      {"RangeToACoincidentPoint", in_circle(
                                      [](Circle& c, Expected& e) {
                                        const auto point = c.graph.add_vertex(
                                            Vector2(c.graph.estimate(c.poses[3]).translation()), 100);
                                        c.graph.add_edge(Range(2), c.poses[3], point);
                                        e.vertices = {point};
                                      },
                                      Kind::kZeroJacobian)},
      {"LandmarkOfWhichOnlyXIsMeasured", in_circle(
                                             [](Circle& c, Expected& e) {
                                               const auto point = c.graph.add_vertex(Vector2(3, 4), 100);
                                               for (const double x : {3.0, 3.1})
                                                 c.graph.add_edge([x](const auto& p) { return p[0] - x; },
                                                                  point);
                                               e.vertices = {point};
                                               e.words = "do not determine y";
                                             },
                                             Kind::kUndeterminedDirection)},
      {"PoseWithoutYaw", poses_without_yaw},
      {"PointIsSeenOnce", in_cameras(
                              [](World& w, Expected& e) {
                                const auto point = w.graph.add_vertex(Vector3(1, 1, 8), 500);
                                e.edges = {w.see(w.cameras[2], point)};
                                e.vertices = {point};
                              },
                              Kind::kSeenOnce)},
      {"PointIsBehindItsCameras", in_cameras(
                                      [](World& w, Expected& e) {
                                        const Vector3 p = w.graph.estimate(w.points[4]);
                                        w.graph.set_estimate(w.points[4], Vector3(p[0], p[1], -p[2]));
                                        e.vertices = {w.points[4]};
                                      },
                                      Kind::kBehindCameras)},
      {"PointRunsToInfinity", in_cameras(
                                  [](World& w, Expected& e) {
                                    w.graph.set_estimate(w.points[7], Vector3(1e6, 0, 1e7));
                                    e.vertices = {w.points[7]};
                                  },
                                  Kind::kFarPoint)},
      {"InformationIsZero", in_circle(
                                [](Circle& c, Expected& e) {
                                  c.graph.set_information(c.edge(5), 0.0);
                                  e.edges = {c.edge(5)};
                                },
                                Kind::kZeroInformation)},
      {"MilliradiansInsteadOfRadians",
       in_circle(
           [](Circle& c, Expected& e) {
             c.graph.set_information(c.edge(5), Information::diagonal(std::vector{400.0, 400.0, 9e8}));
             e.edges = {c.edge(5)};
             e.words = "row 3";
           },
           Kind::kMixedUnits)},
      {"MillimetersInsteadOfMeters",
       in_circle(
           [](Circle& c, Expected& e) {
             c.graph.set_information(c.edge(5), Information::diagonal(std::vector{4e-4, 4e-4, 900.0}));
             e.edges = {c.edge(5)};
             e.words = "smaller than usual";
           },
           Kind::kMixedUnits)},
      {"MeasurementIsAddedTwice", in_circle(
                                      [](Circle& c, Expected& e) {
                                        const EdgeHandle<Between<SE2>> original{c.edge(7)};
                                        e.edges = {c.graph.add_edge(c.graph.measurement(original), 400.0,
                                                                    c.poses[7], c.poses[8])};
                                      },
                                      Kind::kDuplicateEdge)},
      {"LoopClosureIsFalse", false_edge_in_a_grid},
      {"TwoNeighborsAreFixed", in_circle(
                                   [](Circle& c, Expected& e) {
                                     c.graph.fix(c.poses[1]);
                                     e.edges = {c.edge(0)};
                                   },
                                   Kind::kFixedEdge)},
      {"InformationIsTooLargeEverywhere", information_too_large_everywhere},
  };
}

class SeededDefect : public testing::TestWithParam<Defect> {};

TEST_P(SeededDefect, IsNamedWithItsVerticesEdgesAndDirection) {
  const Expected expected = GetParam().plant();
  const Diagnosis diagnosis = diagnose(expected.graph);
  EXPECT_THAT(diagnosis.findings, Contains(AllOf(Field(&Finding::kind, expected.kind),
                                                 Field(&Finding::vertices, IsSupersetOf(expected.vertices)),
                                                 Field(&Finding::edges, IsSupersetOf(expected.edges)),
                                                 Field(&Finding::text, HasSubstr(expected.words)))))
      << diagnosis;
}

TEST(SeededDefects, Are25) {
  EXPECT_EQ(defects().size(), 25u);
}

INSTANTIATE_TEST_SUITE_P(Graphs, SeededDefect, testing::ValuesIn(defects()),
                         [](const auto& defect) { return defect.param.name; });

}  // namespace
}  // namespace boxplus
