// SPDX-License-Identifier: BSD-3-Clause
// Which vertices and edges a plan contains, and which vertices it holds to fix the gauge. A plan holds a
// vertex if the vertex stays at its estimate during a run although the user did not fix it.
#include "plan/plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <vector>

#include "boxplus/manifold/product.h"
#include "boxplus/manifold/rn.h"
#include "boxplus/manifold/se2.h"
#include "boxplus/types/slam3d.h"
#include "linearize/linearizer.h"

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
  for (const detail::GaugeVertex& held : plan.held) ids.push_back(held.id);
  return ids;
}

/// The free motions of the graph, if exactly one component has free motions; otherwise empty.
std::string_view free_motions(const Plan& plan) {
  return plan.freedoms.size() == 1 ? to_string(plan.freedoms[0]) : "";
}

std::vector<Id> moving_ids(const Graph& graph, const Plan& plan) {
  std::vector<Id> ids;
  for (const VertexRef& vertex : plan.block_vertex) ids.push_back(graph.id(vertex));
  return ids;
}

/// A chain of the poses 10, 11 and 12. Pose 11 sees point 5.
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

TEST(Plan, HoldsTheFirstVertexOfTheLargestDimensionIfNothingElseFixesTheGauge) {
  Chain c;
  const Plan plan = make_plan(c.graph, {});
  EXPECT_THAT(held_ids(plan), ElementsAre(10));
  EXPECT_THAT(moving_ids(c.graph, plan), ElementsAre(5, 11, 12));
  EXPECT_EQ(plan.edge_count, 3u);
  EXPECT_THAT(plan.freedoms, IsEmpty());
  EXPECT_FALSE(c.graph.is_fixed(c.poses[0]));
}

TEST(Plan, HoldsNothingIfAVertexIsFixed) {
  Chain c;
  c.graph.fix(c.poses[2]);
  const Plan plan = make_plan(c.graph, {});
  EXPECT_THAT(held_ids(plan), IsEmpty());
  EXPECT_THAT(moving_ids(c.graph, plan), ElementsAre(5, 10, 11));
  EXPECT_THAT(plan.freedoms, IsEmpty());
}

TEST(Plan, HoldsNothingIfAPriorFixesTheGauge) {
  Chain c;
  c.graph.add_edge(kPosePrior, c.poses[2]);
  EXPECT_THAT(held_ids(make_plan(c.graph, {})), IsEmpty());
}

TEST(Plan, OnePositionPriorLeavesTheRotationFreeAndTwoPositionPriorsFixIt) {
  Chain c;
  c.graph.add_edge(kPositionPrior, c.poses[2]);
  const Plan one = make_plan(c.graph, {});
  EXPECT_THAT(held_ids(one), IsEmpty());
  EXPECT_EQ(free_motions(one), "rotation");
  EXPECT_EQ(one.held_scalars.size(), 1u);
  c.graph.add_edge(kPositionPrior, c.poses[0]);
  const Plan two = make_plan(c.graph, {});
  EXPECT_THAT(two.freedoms, IsEmpty());
  EXPECT_THAT(two.held_scalars, IsEmpty());
}

TEST(Plan, AFixedPointLeavesTheRotationFree) {
  Chain c;
  c.graph.fix(c.point);
  const Plan plan = make_plan(c.graph, {});
  EXPECT_THAT(held_ids(plan), IsEmpty());
  EXPECT_EQ(free_motions(plan), "rotation");
}

TEST(Plan, TwoFixedPointsSeenFromOnePoseFixTheGauge) {
  Chain c;
  c.graph.fix(c.point);
  const auto other = c.graph.add_vertex(Point(12, -1), 6);
  c.graph.fix(other);
  c.graph.add_edge(kSighting, c.poses[1], other);
  EXPECT_THAT(make_plan(c.graph, {}).freedoms, IsEmpty());
}

TEST(Plan, TwoFixedPointsInSpaceLeaveTheRotationAboutTheirLineFree) {
  Graph graph;
  const auto pose = graph.add_vertex(SE3(Vector3(1, 2, 3), SO3()), 0);
  for (const double x : {4.0, 9.0}) {
    const auto point = graph.add_vertex(Vector3(x, 0, 1));
    graph.fix(point);
    graph.add_edge(PointObservation3(Vector3(0, 0, 0)), pose, point);
  }
  const Plan plan = make_plan(graph, {});
  ASSERT_EQ(plan.freedoms.size(), 1u);
  EXPECT_EQ(plan.freedoms[0].directions, 1);
  EXPECT_EQ(free_motions(plan), "rotation");
}

/// Cameras, points, and one focal length for all cameras. The estimates of the cameras are T_camera_world.
struct SharedFocalLength {
  Graph graph;
  std::vector<VertexHandle<SE2>> cameras;

  SharedFocalLength() {
    const auto focal = graph.add_vertex(Vector<double, 1>(1.2));
    std::vector<VertexHandle<Point>> points;
    for (int i = 0; i < 6; ++i) points.push_back(graph.add_vertex(Point(i - 2.0, 5 + 0.3 * i * i)));
    for (int i = 0; i < 4; ++i) cameras.push_back(graph.add_vertex(SE2(0.5 * i, 0.1 * i * i, 0.05 * i)));
    for (const auto camera : cameras) {
      for (const auto point : points) {
        graph.add_edge(
            [](const auto& T_camera_world, const auto& x, const auto& f) {
              const auto y = T_camera_world * x;
              return f[0] * y[0] / y[1];
            },
            camera, point, focal);
      }
    }
  }
};

TEST(Plan, FixedCamerasFixTheGaugeEvenIfTheFocalLengthInTheirEdgesIsFree) {
  SharedFocalLength world;
  for (std::size_t i = 0; i < 3; ++i) world.graph.fix(world.cameras[i]);
  const Plan held = make_plan(world.graph, {});
  EXPECT_THAT(held_ids(held), IsEmpty());
  EXPECT_THAT(held.freedoms, IsEmpty());
  EXPECT_THAT(held.undetermined_blocks, IsEmpty());
}

TEST(Plan, ReportsThatTheScaleIsFreeIfOnlyOneCameraIsFixed) {
  SharedFocalLength world;
  world.graph.fix(world.cameras[0]);
  const Plan plan = make_plan(world.graph, {});
  EXPECT_THAT(held_ids(plan), IsEmpty());
  EXPECT_EQ(free_motions(plan), "scale");
  EXPECT_EQ(plan.held_scalars.size(), 1u);
}

TEST(Plan, HoldsACameraAndReportsThatTheScaleIsFreeIfNothingIsFixed) {
  SharedFocalLength world;
  const Plan plan = make_plan(world.graph, {});
  EXPECT_THAT(held_ids(plan), ElementsAre(world.graph.id(world.cameras[0])));
  EXPECT_EQ(free_motions(plan), "scale");
}

TEST(Plan, HoldsOnlyTheDirectionsOfAVertexThatBelongToTheGauge) {
  using Camera = Product<SE2, Vector<double, 1>>;
  Graph graph;
  std::vector<VertexHandle<Camera>> cameras;
  for (int i = 0; i < 3; ++i)
    cameras.push_back(graph.add_vertex(Camera(SE2(0.5 * i, 0.1 * i * i, 0.05 * i), Vector<double, 1>(1.2))));
  for (int i = 0; i < 8; ++i) {
    const auto point = graph.add_vertex(Point(i - 2.0, 5 + 0.3 * i * i));
    for (const auto camera : cameras) {
      graph.add_edge(
          [](const auto& c, const auto& x) {
            const auto y = c.template get<0>() * x;
            return c.template get<1>()[0] * y[0] / y[1];
          },
          camera, point);
    }
  }
  const Plan plan = make_plan(graph, {});
  EXPECT_THAT(held_ids(plan), IsEmpty());
  EXPECT_EQ(free_motions(plan), "translation, rotation and scale");
  ASSERT_EQ(plan.held_scalars.size(), 4u);
  const std::uint32_t focal = plan.structure.offset[0] + 3;
  EXPECT_THAT(plan.held_scalars, testing::Not(testing::Contains(focal)));
}

TEST(Plan, HoldsOneVertexPerComponent) {
  Chain c;
  const auto a = c.graph.add_vertex(SE2(), 3), b = c.graph.add_vertex(SE2(), 4);
  c.graph.add_edge(kBetween, b, a);
  const auto x = c.graph.add_vertex(Point(0, 0), 1), y = c.graph.add_vertex(Point(1, 0), 2);
  c.graph.add_edge([](const auto& p, const auto& q) { return (q - p).eval(); }, y, x);
  EXPECT_THAT(held_ids(make_plan(c.graph, {})), UnorderedElementsAre(1, 3, 10));
}

TEST(Plan, EliminatesAPoseLastIfNothingFixesItAndItsFreeMotionIsUnknown) {
  Graph graph;
  const auto bias = graph.add_vertex(Eigen::Vector3d(0, 0, 0), 1);
  const auto pose = graph.add_vertex(SE2(), 2);
  graph.add_edge([](const auto& b, const auto& p) { return (p.vector() - b).eval(); }, bias, pose);
  const Plan plan = make_plan(graph, {});
  EXPECT_THAT(held_ids(plan), IsEmpty());
  ASSERT_EQ(plan.undetermined_blocks.size(), 1u);
  EXPECT_EQ(graph.id(plan.block_vertex[plan.undetermined_blocks[0]]), 2);
}

TEST(Plan, ParametersDoNotFixTheGaugeAndAreNotHeld) {
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

TEST(Plan, HoldsNothingButReportsFreeMotionsUnderThePoliciesDampAndError) {
  Chain c;
  for (const GaugePolicy gauge : {GaugePolicy::kDamp, GaugePolicy::kError}) {
    const Plan plan = make_plan(c.graph, {.gauge = gauge});
    EXPECT_THAT(held_ids(plan), IsEmpty());
    EXPECT_EQ(free_motions(plan), "translation and rotation");
    EXPECT_EQ(plan.block_vertex.size(), 4u);
  }
}

TEST(Plan, OfASubsetOfVerticesContainsTheEdgesThatTouchThem) {
  Chain c;
  const std::array<VertexRef, 1> subset{c.poses[2]};
  const Plan plan = make_plan(c.graph, {.vertices = subset});
  EXPECT_THAT(moving_ids(c.graph, plan), ElementsAre(12));
  EXPECT_EQ(plan.edge_count, 1u);
  EXPECT_THAT(held_ids(plan), IsEmpty());
}

TEST(Plan, OfASubsetOfEdgesContainsTheirVertices) {
  Chain c;
  c.graph.fix(c.poses[0]);
  const std::array<EdgeRef, 1> subset{c.edges[0]};
  const Plan plan = make_plan(c.graph, {.edges = subset});
  EXPECT_THAT(moving_ids(c.graph, plan), ElementsAre(11));
  EXPECT_EQ(plan.edge_count, 1u);
}

TEST(Plan, ContainsTheEdgesOfTheRequestedLevel) {
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

TEST(Plan, EdgesBetweenFixedVerticesContributeOnlyToChi2) {
  Chain c;
  for (const auto& pose : c.poses) c.graph.fix(pose);
  const Plan plan = make_plan(c.graph, {});
  EXPECT_THAT(moving_ids(c.graph, plan), ElementsAre(5));
  Linearizer linearizer(c.graph, plan);
  EXPECT_NEAR(linearizer.chi2(), c.graph.chi2(), 1e-12);
}

/// A graph of poses that see points, which are eliminated, with sensors whose scale is unknown. Each sighting
/// lists the ids of a pose, a point and a scale.
Graph with_scales(const std::vector<std::array<Id, 3>>& sightings) {
  constexpr auto kScaled = [](const auto& pose, const auto& point, const auto& scale) {
    return (scale * pose.inverse_times(point)).eval();
  };
  Graph graph;
  std::map<Id, VertexHandle<SE2>> poses;
  std::map<Id, VertexHandle<Point>> points;
  std::map<Id, VertexHandle<double>> scales;
  for (const auto& [pose, point, scale] : sightings) {
    if (!poses.contains(pose)) poses[pose] = graph.add_vertex(SE2(static_cast<double>(pose), 0, 0), pose);
    if (!points.contains(point))
      points[point] = graph.add_vertex(Point(1, static_cast<double>(point)), point);
    if (!scales.contains(scale)) scales[scale] = graph.add_vertex(1.0, scale);
    graph.set_eliminated(points[point], true);
    graph.add_edge(kScaled, poses[pose], points[point], scales[scale]);
  }
  graph.add_edge(kPosePrior, poses.begin()->second);
  return graph;
}

TEST(Plan, PutsKeptVerticesThatShareAllEliminatedVerticesSideBySide) {
  const Graph graph = with_scales({{0, 20, 12}, {0, 21, 12}, {1, 20, 11}, {1, 22, 11}, {2, 21, 10}});
  EXPECT_THAT(moving_ids(graph, make_plan(graph, {})), ElementsAre(20, 21, 22, 0, 12, 1, 11, 2, 10));
}

TEST(Plan, OrdersKeptVerticesByIdIfNoTwoShareAllEliminatedVertices) {
  const Graph graph = with_scales({{0, 20, 10}, {1, 21, 10}, {2, 22, 11}, {3, 20, 11}, {3, 23, 10}});
  EXPECT_THAT(moving_ids(graph, make_plan(graph, {.gauge = GaugePolicy::kDamp})),
              ElementsAre(20, 21, 22, 23, 0, 1, 2, 3, 10, 11));
}

TEST(Plan, RefusesAndNamesTwoEliminatedVerticesInOneEdge) {
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

TEST(Plan, HoldsNothingIfAnEdgeMeasuresTheProductOfTwoVertices) {
  Graph graph;
  const auto a = graph.add_vertex(3.0), b = graph.add_vertex(4.0);
  graph.add_edge([](const auto& x, const auto& y) { return x * y - 2.0; }, a, b);
  const Plan plan = make_plan(graph, {});
  EXPECT_THAT(held_ids(plan), IsEmpty());
  EXPECT_THAT(plan.freedoms, IsEmpty());
  EXPECT_EQ(plan.undetermined_blocks.size(), 1u);
}

TEST(Plan, DisabledPriorsFixTheGaugeToo) {
  Chain c;
  const auto prior = c.graph.add_edge(kPosePrior, c.poses[2]);
  c.graph.set_enabled(prior, false);
  EXPECT_THAT(held_ids(make_plan(c.graph, {})), IsEmpty());
}

}  // namespace
}  // namespace boxplus
