// SPDX-License-Identifier: BSD-3-Clause
// The active set and the gauge rule.
#include "boxplus/linearize/plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "boxplus/linearize/linearizer.h"
#include "boxplus/manifold/rn.h"
#include "boxplus/manifold/se2.h"

namespace boxplus {
namespace {

using Point = Eigen::Vector2d;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

constexpr auto kBetween = [](const auto& a, const auto& b) { return a.inverse_times(b).vector(); };
constexpr auto kSighting = [](const auto& pose, const auto& point) { return pose.inverse_times(point); };
constexpr auto kPosePrior = [](const auto& pose) { return pose.vector(); };
constexpr auto kPositionPrior = [](const auto& pose) { return pose.translation(); };

std::vector<Id> held_ids(const Plan& plan) {
  std::vector<Id> ids;
  for (const GaugeVertex& held : plan.held) ids.push_back(held.id);
  return ids;
}

std::vector<Id> moving_ids(const Graph& graph, const Plan& plan) {
  std::vector<Id> ids;
  for (const VertexRef& vertex : plan.block_vertex) ids.push_back(graph.id(vertex));
  return ids;
}

/// Poses 10, 11, 12 in a chain and point 5, seen from pose 11.
struct Chain {
  Graph graph;
  std::vector<VertexHandle<SE2>> poses;
  VertexHandle<Point> point;
  std::vector<EdgeRef> edges;

  Chain() {
    for (Id id = 10; id < 13; ++id) poses.push_back(graph.add_vertex(SE2(static_cast<double>(id), 0, 0), id));
    point = graph.add_vertex(Point(11, 3), 5);
    edges.push_back(graph.add_edge(kBetween, poses[0], poses[1]));
    edges.push_back(graph.add_edge(kBetween, poses[1], poses[2]));
    edges.push_back(graph.add_edge(kSighting, poses[1], point));
  }
};

TEST(Plan, HoldsTheLowestVertexOfLargestDimensionWhereNothingElseDoes) {
  Chain c;
  const Plan plan = make_plan(c.graph, {});
  EXPECT_THAT(held_ids(plan), ElementsAre(10));
  EXPECT_THAT(moving_ids(c.graph, plan), ElementsAre(5, 11, 12));
  EXPECT_EQ(plan.edge_count, 3u);
  EXPECT_EQ(plan.damped_components, 0);
  EXPECT_FALSE(c.graph.is_fixed(c.poses[0]));
}

TEST(Plan, HoldsNothingWhereAVertexIsFixed) {
  Chain c;
  c.graph.fix(c.poses[2]);
  const Plan plan = make_plan(c.graph, {});
  EXPECT_THAT(held_ids(plan), IsEmpty());
  EXPECT_THAT(moving_ids(c.graph, plan), ElementsAre(5, 10, 11));
  EXPECT_EQ(plan.damped_components, 0);
}

TEST(Plan, HoldsNothingWhereAPriorDoes) {
  Chain c;
  c.graph.add_edge(kPosePrior, c.poses[2]);
  EXPECT_THAT(held_ids(make_plan(c.graph, {})), IsEmpty());
}

TEST(Plan, CountsTheRowsOfPriors) {
  Chain c;
  c.graph.add_edge(kPositionPrior, c.poses[2]);
  const Plan one = make_plan(c.graph, {});
  EXPECT_THAT(held_ids(one), IsEmpty());
  EXPECT_EQ(one.damped_components, 1);
  c.graph.add_edge(kPositionPrior, c.poses[0]);
  EXPECT_EQ(make_plan(c.graph, {}).damped_components, 0);
}

TEST(Plan, AFixedPointHoldsAPoseOnlyInPart) {
  Chain c;
  c.graph.fix(c.point);
  const Plan plan = make_plan(c.graph, {});
  EXPECT_THAT(held_ids(plan), IsEmpty());
  EXPECT_EQ(plan.damped_components, 1);
}

TEST(Plan, HoldsOneVertexPerComponent) {
  Chain c;
  const auto a = c.graph.add_vertex(SE2(), 3), b = c.graph.add_vertex(SE2(), 4);
  c.graph.add_edge(kBetween, b, a);
  const auto x = c.graph.add_vertex(Point(0, 0), 1), y = c.graph.add_vertex(Point(1, 0), 2);
  c.graph.add_edge([](const auto& p, const auto& q) { return (q - p).eval(); }, y, x);
  EXPECT_THAT(held_ids(make_plan(c.graph, {})), UnorderedElementsAre(1, 3, 10));
}

TEST(Plan, PrefersPosesAmongVerticesOfOneDimension) {
  Graph graph;
  const auto bias = graph.add_vertex(Eigen::Vector3d(0, 0, 0), 1);
  const auto pose = graph.add_vertex(SE2(), 2);
  graph.add_edge([](const auto& b, const auto& p) { return (p.vector() - b).eval(); }, bias, pose);
  EXPECT_THAT(held_ids(make_plan(graph, {})), ElementsAre(2));
}

TEST(Plan, ParametersDoNotAnchorAndAreNotHeld) {
  Graph graph;
  const auto offset = graph.add_parameter(SE2(), 0);
  const auto a = graph.add_vertex(SE2(), 1), b = graph.add_vertex(SE2(), 2);
  const auto edge = [](const auto& x, const auto& y, const auto& o) {
    return (x * o).inverse_times(y).vector();
  };
  graph.add_edge(edge, a, b, offset);
  EXPECT_THAT(held_ids(make_plan(graph, {})), ElementsAre(1));
  graph.unfix(offset);
  const Plan plan = make_plan(graph, {});
  EXPECT_THAT(held_ids(plan), ElementsAre(1));
  EXPECT_THAT(moving_ids(graph, plan), ElementsAre(0, 2));
}

TEST(Plan, PoliciesDampAndErrorHoldNothingButCountTheComponent) {
  Chain c;
  for (const GaugePolicy gauge : {GaugePolicy::kDamp, GaugePolicy::kError}) {
    const Plan plan = make_plan(c.graph, {.gauge = gauge});
    EXPECT_THAT(held_ids(plan), IsEmpty());
    EXPECT_EQ(plan.free_components, 1);
    EXPECT_EQ(plan.block_vertex.size(), 4u);
  }
}

TEST(Plan, AVertexThatWasFoundToBeObservableIsNotHeld) {
  Chain c;
  const std::array<VertexRef, 1> observable{c.poses[0]};
  const Plan plan = make_plan(c.graph, {.never_hold = observable});
  EXPECT_THAT(held_ids(plan), IsEmpty());
  EXPECT_EQ(plan.block_vertex.size(), 4u);
}

TEST(Plan, TakesASubsetOfVerticesWithTheEdgesThatTouchIt) {
  Chain c;
  const std::array<VertexRef, 1> subset{c.poses[2]};
  const Plan plan = make_plan(c.graph, {.vertices = subset});
  EXPECT_THAT(moving_ids(c.graph, plan), ElementsAre(12));
  EXPECT_EQ(plan.edge_count, 1u);
  EXPECT_THAT(held_ids(plan), IsEmpty());
}

TEST(Plan, TakesASubsetOfEdges) {
  Chain c;
  c.graph.fix(c.poses[0]);
  const std::array<EdgeRef, 1> subset{c.edges[0]};
  const Plan plan = make_plan(c.graph, {.edges = subset});
  EXPECT_THAT(moving_ids(c.graph, plan), ElementsAre(11));
  EXPECT_EQ(plan.edge_count, 1u);
}

TEST(Plan, TakesTheEdgesOfItsLevel) {
  Chain c;
  c.graph.set_level(c.edges[1], 1);
  EXPECT_EQ(make_plan(c.graph, {}).edge_count, 2u);
  EXPECT_THAT(moving_ids(c.graph, make_plan(c.graph, {.level = 1})), ElementsAre(12));
  EXPECT_EQ(make_plan(c.graph, {.level = -1}).edge_count, 3u);
  EXPECT_EQ(make_plan(c.graph, {.level = 2}).edge_count, 0u);
}

TEST(Plan, RefusesStaleHandles) {
  Chain c;
  const std::array<VertexRef, 1> vertex{c.point};
  const std::array<EdgeRef, 1> edge{c.edges[2]};
  c.graph.remove(c.point);
  EXPECT_THROW(make_plan(c.graph, {.vertices = vertex}), InvalidArgument);
  EXPECT_THROW(make_plan(c.graph, {.edges = edge}), InvalidArgument);
}

TEST(Plan, OfAnEmptyGraphIsEmpty) {
  const Graph graph;
  const Plan plan = make_plan(graph, {});
  EXPECT_EQ(plan.scalars(), 0u);
  Linearizer linearizer(graph, plan);
  linearizer.linearize({});
  EXPECT_EQ(linearizer.chi2(), 0);
}

TEST(Plan, EdgesBetweenFixedVerticesCountInChiSquaredOnly) {
  Chain c;
  for (const auto& pose : c.poses) c.graph.fix(pose);
  const Plan plan = make_plan(c.graph, {});
  EXPECT_THAT(moving_ids(c.graph, plan), ElementsAre(5));
  Linearizer linearizer(c.graph, plan);
  EXPECT_NEAR(linearizer.chi2(), c.graph.chi2(), 1e-12);
}

TEST(Plan, NamesTwoEliminatedVerticesInOneEdge) {
  Chain c;
  c.graph.set_eliminated(c.poses[1], true);
  c.graph.set_eliminated(c.point, true);
  c.graph.fix(c.poses[0]);
  try {
    make_plan(c.graph, {});
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_THAT(error.what(), HasSubstr("11"));
    EXPECT_THAT(error.what(), HasSubstr("5"));
  }
}

/// Poses at 0 and 2 with the measurement 1 between them, at the minimum over the second alone.
TEST(Plan, HoldingAGaugeFreedomCostsNothing) {
  Graph graph;
  const auto a = graph.add_vertex(SE2(1, 2, 0.5)), b = graph.add_vertex(SE2(1, 2, 0.5));
  graph.add_edge(kBetween, a, b);
  graph.add_edge(kBetween, 2.0, b, a);
  const Plan plan = make_plan(graph, {});
  ASSERT_THAT(held_ids(plan), ElementsAre(0));
  Linearizer linearizer(graph, plan);
  EXPECT_NEAR(linearizer.held_vertex_decrease(0), 0, 1e-20);
}

TEST(Plan, HoldingAnObservableVertexCostsSomething) {
  Graph graph;
  const auto a = graph.add_vertex(3.0), b = graph.add_vertex(4.0);
  // Products of both: not invariant under a common shift.
  graph.add_edge([](const auto& x, const auto& y) { return x * y - 2.0; }, a, b);
  const Plan plan = make_plan(graph, {});
  ASSERT_THAT(held_ids(plan), ElementsAre(0));
  Linearizer linearizer(graph, plan);
  EXPECT_NEAR(linearizer.held_vertex_decrease(0), 100, 1e-10);  // e² where one vertex can zero the error
}

TEST(Plan, AFlatDirectionOfTheHeldVertexIsLeftOut) {
  Graph graph;
  const auto a = graph.add_vertex(Point(0.1, 0.3), 0), b = graph.add_vertex(Point(1, 1), 1);
  const Point u(1.0 / 3, 1.0 / 7);
  const auto along = [u](const auto& x, const auto& y) {
    return u[0] * (y[0] - x[0]) + u[1] * (y[1] - x[1]);
  };
  for (const double omega : {0.1, 0.7, 1.3}) graph.add_edge(along, omega, a, b);
  const Plan plan = make_plan(graph, {});
  Linearizer linearizer(graph, plan);
  EXPECT_NEAR(linearizer.held_vertex_decrease(0), graph.chi2(), 1e-9);
}

}  // namespace
}  // namespace boxplus
