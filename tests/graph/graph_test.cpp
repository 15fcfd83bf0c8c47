// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/graph/graph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <type_traits>
#include <vector>

#include "boxplus/manifold/rn.h"
#include "boxplus/manifold/se2.h"
#include "boxplus/robust/huber.h"

namespace boxplus {
namespace {

using Point = Eigen::Vector2d;
using testing::ElementsAre;
using testing::HasSubstr;

/// The message of the InvalidArgument that `f` throws, or an empty string.
template <class F>
std::string complaint(F&& f) {
  try {
    f();
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return {};
}

constexpr auto kDifference = [](const auto& x, const auto& y) { return y - x; };
constexpr auto kPrior = [](const auto& x) { return x - 1.0; };

TEST(Graph, EstimatesOfOneTypeAreContiguousInMemory) {
  Graph graph;
  const auto a = graph.add_vertex(1.0);
  graph.add_vertex(SE2(1, 2, 3));
  const auto b = graph.add_vertex(2.0);
  EXPECT_EQ(&graph.estimate(a) + 1, &graph.estimate(b));
  EXPECT_EQ(graph.vertex_pools().size(), 2u);
  EXPECT_EQ(graph.vertex_count(), 3u);
}

TEST(Graph, EdgesOfOneTypeShareAPool) {
  Graph graph;
  const auto a = graph.add_vertex(1.0), b = graph.add_vertex(2.0), c = graph.add_vertex(3.0);
  const auto first = graph.add_edge(kDifference, a, b), second = graph.add_edge(kDifference, b, c);
  EXPECT_EQ(first.pool, second.pool);
  EXPECT_NE(graph.add_edge(kPrior, a).pool, first.pool);
  EXPECT_EQ(graph.edge_count(), 3u);
  EXPECT_THAT(graph.vertices(second), ElementsAre(VertexRef(b), VertexRef(c)));
}

TEST(Graph, AutomaticIdsSkipIdsThatAreTaken) {
  Graph graph;
  graph.add_vertex(0.0, 0);
  graph.add_vertex(0.0, 2);
  EXPECT_EQ(graph.id(graph.add_vertex(0.0)), 1);
  EXPECT_EQ(graph.id(graph.add_vertex(0.0)), 3);
}

TEST(Graph, TakenAndNegativeIdsAreRefused) {
  Graph graph;
  graph.add_vertex(0.0, 7);
  EXPECT_THAT(complaint([&] { graph.add_vertex(Point(0, 0), 7); }), HasSubstr("7 is taken"));
  EXPECT_THAT(complaint([&] { graph.add_vertex(0.0, -1); }), HasSubstr("-1"));
  EXPECT_EQ(graph.vertex_count(), 1u);
}

TEST(Graph, AVertexIsFoundByIdAndType) {
  Graph graph;
  const auto a = graph.add_vertex(0.5, 7);
  EXPECT_EQ(graph.vertex<double>(7), a);
  EXPECT_EQ(graph.find_vertex(7), VertexRef(a));
  EXPECT_EQ(graph.find_vertex(8), std::nullopt);
  EXPECT_THAT(complaint([&] { (void)graph.vertex<SE2>(7); }), HasSubstr("vertex 7: expected the type"));
  EXPECT_THAT(complaint([&] { (void)graph.vertex<double>(8); }), HasSubstr("no vertex 8"));
}

TEST(Graph, ChangeIdAssignsTheNewIdAndFreesTheOldOne) {
  Graph graph;
  const auto a = graph.add_vertex(0.5, 7), b = graph.add_vertex(0.5, 8);
  graph.change_id(a, 9);
  EXPECT_EQ(graph.id(a), 9);
  EXPECT_EQ(graph.find_vertex(7), std::nullopt);
  EXPECT_EQ(graph.vertex<double>(9), a);
  EXPECT_NE(complaint([&] { graph.change_id(b, 9); }), "");
  EXPECT_NE(complaint([&] { graph.change_id(b, -9); }), "");
  graph.change_id(b, 8);
  EXPECT_EQ(graph.id(b), 8);
}

TEST(Graph, VerticesCanBeFixedAndUnfixed) {
  Graph graph;
  const auto a = graph.add_vertex(0.5);
  EXPECT_FALSE(graph.is_fixed(a));
  const auto revision = graph.revision();
  graph.fix(a);
  EXPECT_TRUE(graph.is_fixed(a));
  EXPECT_NE(graph.revision(), revision);
  graph.unfix(a);
  EXPECT_FALSE(graph.is_fixed(a));
}

TEST(Graph, RemovingAVertexRemovesItsEdges) {
  Graph graph;
  const auto a = graph.add_vertex(1.0), b = graph.add_vertex(2.0), c = graph.add_vertex(3.0);
  const auto ab = graph.add_edge(kDifference, a, b), bc = graph.add_edge(kDifference, b, c);
  const auto prior = graph.add_edge(kPrior, c);
  graph.remove(a);
  EXPECT_FALSE(graph.contains(a));
  EXPECT_FALSE(graph.contains(ab));
  EXPECT_TRUE(graph.contains(bc));
  EXPECT_TRUE(graph.contains(prior));
  EXPECT_EQ(graph.edge_count(), 2u);
  EXPECT_EQ(graph.vertex_count(), 2u);
}

TEST(Graph, ASlotIsReusedWithANewGeneration) {
  Graph graph;
  const auto a = graph.add_vertex(1.0);
  graph.fix(a);
  graph.set_eliminated(a, true);
  graph.remove(a);
  const auto b = graph.add_vertex(2.0);
  EXPECT_EQ(b.slot, a.slot);
  EXPECT_NE(b.generation, a.generation);
  EXPECT_FALSE(graph.is_fixed(b));
  EXPECT_FALSE(graph.is_eliminated(b));
  EXPECT_THROW((void)graph.estimate(a), InvalidArgument);
  EXPECT_THROW(graph.set_estimate(a, 1.0), InvalidArgument);
  EXPECT_THROW(graph.remove(a), InvalidArgument);
  EXPECT_THROW(graph.fix(a), InvalidArgument);
  EXPECT_THROW((void)graph.id(a), InvalidArgument);
  EXPECT_THROW(graph.add_edge(kPrior, a), InvalidArgument);
}

TEST(Graph, AnEdgeInAReusedSlotDoesNotGetTheSettingsOfTheRemovedEdge) {
  Graph graph;
  const auto a = graph.add_vertex(1.0), b = graph.add_vertex(5.0);
  const auto old = graph.add_edge(kDifference, 9.0, a, b);
  graph.set_kernel(old, Huber(1));
  graph.set_level(old, 3);
  graph.set_enabled(old, false);
  graph.remove(old);
  const auto edge = graph.add_edge(kDifference, 2.0, b, a);
  EXPECT_EQ(edge.slot, old.slot);
  EXPECT_EQ(graph.kernel(edge), nullptr);
  EXPECT_EQ(graph.level(edge), 0);
  EXPECT_TRUE(graph.is_enabled(edge));
  EXPECT_EQ(graph.chi2(edge), 32);
  EXPECT_THROW((void)graph.chi2(old), InvalidArgument);
  EXPECT_THROW((void)graph.measurement(old), InvalidArgument);
  EXPECT_THROW(graph.remove(old), InvalidArgument);
}

TEST(Graph, ARemovedEdgeReleasesItsKernel) {
  Graph graph;
  const auto kernel = std::make_shared<const Huber>(1);
  const auto edge = graph.add_edge(kPrior, graph.add_vertex(1.0));
  graph.set_kernel(edge, kernel);
  EXPECT_EQ(kernel.use_count(), 2);
  graph.remove(edge);
  EXPECT_EQ(kernel.use_count(), 1);
}

TEST(Graph, AVertexMayNotAppearTwiceInOneEdge) {
  Graph graph;
  const auto a = graph.add_vertex(1.0, 5);
  EXPECT_THAT(complaint([&] { graph.add_edge(kDifference, a, a); }), HasSubstr("vertex 5 appears twice"));
}

TEST(Graph, AHandleOfAnotherGraphIsRefusedIfItsTypeDiffers) {
  Graph graph, other;
  graph.add_vertex(Point(1, 2));
  graph.add_vertex(1.0);
  const auto foreign = other.add_vertex(1.0);  // in pool 0 of `other`; pool 0 of `graph` holds points
  EXPECT_THROW((void)graph.estimate(foreign), InvalidArgument);
  EXPECT_THROW(graph.set_estimate(foreign, 2.0), InvalidArgument);
  EXPECT_THROW(graph.add_edge(kPrior, foreign), InvalidArgument);
  const std::vector<VertexHandle<double>> range{foreign};
  EXPECT_THROW(graph.add_edge([](const auto& x) { return x[0]; }, range), InvalidArgument);
}

TEST(Graph, AnEdgeHandleOfAnotherGraphIsRefusedIfItsTypeDiffers) {
  Graph graph, other;
  const auto a = graph.add_vertex(1.0), b = graph.add_vertex(2.0);
  graph.add_edge(kDifference, a, b);
  const double target = 5;
  const auto foreign = other.add_edge([target](double x) { return x - target; }, other.add_vertex(1.0));
  EXPECT_THROW((void)graph.measurement(foreign), InvalidArgument);
}

TEST(Graph, AHandleOfAnotherGraphIsRefusedEvenIfItsSlotAndTypeMatch) {
  std::vector<Graph> graphs(50);
  std::vector<VertexHandle<double>> vertices;
  std::vector<EdgeRef> edges;
  for (Graph& graph : graphs) {
    vertices.push_back(graph.add_vertex(1.0));
    edges.push_back(graph.add_edge(kPrior, vertices.back()));
    graph.remove(graph.add_vertex(2.0));  // so that the next vertex reuses its slot
    graph.add_vertex(3.0);
  }
  for (std::size_t a = 0; a < graphs.size(); ++a) {
    for (std::size_t b = 0; b < graphs.size(); ++b) {
      EXPECT_EQ(graphs[a].contains(vertices[b]), a == b);
      EXPECT_EQ(graphs[a].contains(edges[b]), a == b);
    }
  }
  EXPECT_THAT(complaint([&] { graphs[0].fix(vertices[1]); }), HasSubstr("belongs to another graph"));
  EXPECT_THAT(complaint([&] { (void)graphs[0].chi2(edges[1]); }), HasSubstr("belongs to another graph"));
  EXPECT_THAT(complaint([&] { graphs[0].add_edge(kPrior, vertices[1]); }),
              HasSubstr("belongs to another graph"));
}

TEST(Graph, AMovedFromGraphRefusesTheHandlesThatItCreatedBeforeTheMove) {
  Graph graph;
  const auto a = graph.add_vertex(1.0);
  const Graph moved(std::move(graph));
  const auto b = graph.add_vertex(2.0);  // NOLINT(bugprone-use-after-move): a moved-from graph is empty
  EXPECT_TRUE(moved.contains(a));
  EXPECT_FALSE(moved.contains(b));
  EXPECT_TRUE(graph.contains(b));
  EXPECT_FALSE(graph.contains(a));
}

TEST(Graph, EigenVectorsAndBoxplusVectorsAreTheSameVertexType) {
  Graph graph;
  const auto ours = graph.add_vertex(Vector2(1, 2), 0);
  const auto eigens = graph.add_vertex(Eigen::Vector2d(3, 4), 1);
  const auto expression = graph.add_vertex(2.0 * Eigen::Vector2d(3, 4), 2);
  static_assert(std::is_same_v<decltype(ours), decltype(eigens)>);
  static_assert(std::is_same_v<decltype(ours), decltype(expression)>);
  EXPECT_EQ(graph.vertex_pools().size(), 1u);
  EXPECT_EQ(graph.vertex<Eigen::Vector2d>(0), ours);
  EXPECT_EQ(graph.vertex<Vector2>(1), eigens);
  EXPECT_EQ(graph.typed<Eigen::Vector2d>(*graph.find_vertex(1)), eigens);
  EXPECT_EQ(graph.estimate(expression), Vector2(6, 8));
  const auto parameter = graph.add_parameter(Eigen::Vector3d(1, 2, 3), 5);
  EXPECT_EQ(graph.parameter<Vector3>(5), parameter);
  EXPECT_EQ(graph.parameter<Eigen::Vector3d>(5), parameter);
  const auto dynamic = graph.add_vertex(Eigen::VectorXd(Eigen::VectorXd::Ones(4)));
  EXPECT_EQ((graph.vertex<Vector<double, kDynamic>>(graph.id(dynamic))), dynamic);
}

TEST(Graph, AHandleOfAnEigenVectorConvertsToAHandleOfABoxplusVectorAndBack) {
  Graph graph;
  VertexHandle<Eigen::Vector2d> eigens = graph.add_vertex(Eigen::Vector2d(1, 2));
  const VertexHandle<Vector2> ours = eigens;
  eigens = ours;
  graph.set_estimate(eigens, Vector2(3, 4));
  graph.set_estimate(ours, Eigen::Vector2d(3, 5));
  graph.set_estimate(ours, 2 * graph.estimate(eigens));
  EXPECT_EQ(graph.estimate(eigens), Eigen::Vector2d(6, 10));
  const std::vector<VertexHandle<Eigen::Vector2d>> range{eigens};
  graph.add_edge([](const auto& x) { return x[0]; }, eigens);
  EXPECT_EQ(graph.error(graph.add_edge([](const auto& x) { return x[0][1]; }, range))[0], 10);
}

TEST(Graph, Chi2SumsOverEnabledEdgesAndAppliesTheirKernels) {
  Graph graph;
  const auto a = graph.add_vertex(4.0), b = graph.add_vertex(6.0);
  graph.add_edge(kDifference, a, b);                  // chi2 = 4
  const auto prior = graph.add_edge(kPrior, 2.0, a);  // chi2 = 2·9
  EXPECT_EQ(graph.chi2(), 22);
  graph.set_kernel(prior, Huber(1));
  EXPECT_NEAR(graph.chi2(), 4 + 2 * std::sqrt(18) - 1, 1e-12);
  EXPECT_EQ(graph.chi2(prior), 18);
  EXPECT_THAT(graph.error(prior), ElementsAre(3));
  graph.set_enabled(prior, false);
  EXPECT_EQ(graph.chi2(), 4);
  graph.set_enabled(prior, true);
  graph.set_kernel(prior, nullptr);
  EXPECT_EQ(graph.chi2(), 22);
}

TEST(Graph, ReservesNoMoreEdgesThanOneTypeCanHave) {
  Graph graph;
  const auto a = graph.add_vertex(4.0);
  const auto edge = graph.add_edge(kPrior, a);
  graph.reserve_edges(edge, 100);
  for (const std::size_t count : {std::size_t{1} << 32, std::numeric_limits<std::size_t>::max()}) {
    EXPECT_THAT(complaint([&] { graph.reserve_edges(edge, count); }),
                HasSubstr("expected at most 4294967295 edges, got "));
  }
  EXPECT_EQ(graph.edge_count(), 1u);
}

TEST(Graph, ANewLevelAdvancesTheRevisionAndNewValuesDoNot) {
  Graph graph;
  const auto a = graph.add_vertex(4.0);
  const auto edge = graph.add_edge(kPrior, a);
  const auto revision = graph.revision();
  graph.set_estimate(a, 3.0);
  graph.set_enabled(edge, false);
  graph.set_kernel(edge, Huber(1));
  graph.set_information(edge, 3.0);
  graph.set_measurement(edge, kPrior);
  graph.set_level(edge, 0);
  EXPECT_EQ(graph.revision(), revision);
  graph.set_level(edge, 2);
  EXPECT_NE(graph.revision(), revision);
  EXPECT_EQ(graph.level(edge), 2);
}

TEST(Graph, ParametersAreFixedAndTheirIdsAreSeparateFromVertexIds) {
  Graph graph;
  const auto a = graph.add_vertex(1.0, 0);
  const auto offset = graph.add_parameter(2.0, 0);
  EXPECT_EQ(graph.id(offset), 0);
  EXPECT_EQ(graph.parameter<double>(0), offset);
  EXPECT_EQ(graph.vertex<double>(0), a);
  EXPECT_TRUE(graph.is_fixed(offset));
  EXPECT_EQ(graph.vertex_count(), 1u);
  EXPECT_EQ(graph.parameter_count(), 1u);
  EXPECT_THAT(graph.all_vertices(), ElementsAre(VertexRef(a)));
  EXPECT_THAT(graph.all_parameters(), ElementsAre(VertexRef(offset)));
  EXPECT_THAT(complaint([&] { graph.add_parameter(1.0, 0); }), HasSubstr("parameter id 0 is taken"));
  graph.remove(offset);
  EXPECT_EQ(graph.find_parameter(0), std::nullopt);
  EXPECT_TRUE(graph.contains(a));
}

TEST(Graph, AllVerticesAreListedInTheOrderOfTheirIds) {
  Graph graph;
  const auto c = graph.add_vertex(1.0, 9);
  const auto a = graph.add_vertex(Point(1, 2), 3);
  const auto b = graph.add_vertex(1.0, 5);
  EXPECT_THAT(graph.all_vertices(), ElementsAre(VertexRef(a), VertexRef(b), VertexRef(c)));
}

TEST(Graph, OldHandlesAreStaleAfterClear) {
  Graph graph;
  const auto a = graph.add_vertex(1.0, 4);
  const auto edge = graph.add_edge(kPrior, a);
  const auto revision = graph.revision();
  graph.clear();
  EXPECT_NE(graph.revision(), revision);
  EXPECT_EQ(graph.vertex_count() + graph.edge_count(), 0u);
  const auto b = graph.add_vertex(2.0, 4);
  graph.add_edge(kPrior, b);
  EXPECT_FALSE(graph.contains(a));
  EXPECT_FALSE(graph.contains(edge));
  EXPECT_EQ(graph.estimate(b), 2);
}

TEST(Graph, HandlesStayValidIfTheGraphIsMoved) {
  Graph graph;
  const auto a = graph.add_vertex(4.0), b = graph.add_vertex(6.0);
  const auto edge = graph.add_edge(kDifference, a, b);
  Graph moved(std::move(graph));
  EXPECT_EQ(graph.vertex_count(), 0u);  // NOLINT(bugprone-use-after-move): a moved-from graph is empty
  EXPECT_EQ(moved.chi2(edge), 4);
  Graph assigned;
  assigned.add_vertex(Point(1, 2));
  assigned = std::move(moved);
  assigned.set_estimate(a, 5.0);
  EXPECT_EQ(assigned.chi2(edge), 1);
  EXPECT_EQ(assigned.chi2(), 1);
}

TEST(Graph, ObserversSeeThatItWasMovedAssignedToOrDestroyed) {
  Graph graph;
  const auto of_graph = graph.life();
  EXPECT_EQ(graph.life(), of_graph);
  const Graph copy(graph);
  EXPECT_FALSE(of_graph->is_over);
  Graph moved(std::move(graph));
  EXPECT_TRUE(of_graph->is_over);
  const auto of_moved = moved.life();
  moved = Graph();
  EXPECT_TRUE(of_moved->is_over);
  const auto of_assigned = moved.life();
  moved = copy;
  EXPECT_TRUE(of_assigned->is_over);
  std::shared_ptr<detail::LifeState> of_destroyed;
  {
    Graph destroyed;
    of_destroyed = destroyed.life();
    destroyed.clear();
    EXPECT_FALSE(of_destroyed->is_over);
  }
  EXPECT_TRUE(of_destroyed->is_over);
}

}  // namespace
}  // namespace boxplus
