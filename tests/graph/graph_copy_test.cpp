// SPDX-License-Identifier: BSD-3-Clause
// Copies of a Graph.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <span>
#include <vector>

#include "boxplus/graph/graph.h"
#include "boxplus/manifold/rn.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/robust/huber.h"
#include "boxplus/types/slam2d.h"

namespace boxplus {
namespace {

using testing::ElementsAre;

constexpr auto kDifference = [](const auto& x, const auto& y) { return y - x; };
constexpr auto kSum = [](std::span<const double> all) {
  double sum = 0;
  for (const double x : all) sum += x;
  return sum;
};

auto distance_of(double target) {
  return [target](const auto& x, const auto& y) { return y - x - target; };
}

TEST(GraphCopy, HasTheElementsOfItsOriginalUnderTheSameHandles) {
  Graph graph;
  const auto removed = graph.add_vertex(0.0);
  const auto a = graph.add_vertex(1.0, 7), b = graph.add_vertex(2.0);
  const auto pose = graph.add_vertex(SE2(1, 2, 0.5));
  const auto offset = graph.add_parameter(0.25, 3);
  graph.remove(removed);
  graph.fix(a);
  graph.set_eliminated(b, true);
  const auto edge = graph.add_edge(distance_of(5), 2.0, a, b);
  const auto prior = graph.add_edge(Prior(SE2(1, 2, 0)), pose);
  graph.set_level(edge, 2);
  graph.set_enabled(prior, false);

  const Graph copy = graph;
  EXPECT_EQ(copy.estimate(a), 1);
  EXPECT_EQ(copy.estimate(pose).vector(), SE2(1, 2, 0.5).vector());
  EXPECT_EQ(copy.vertex<double>(7), a);
  EXPECT_EQ(copy.parameter<double>(3), offset);
  EXPECT_TRUE(copy.is_fixed(a));
  EXPECT_TRUE(copy.is_eliminated(b));
  EXPECT_FALSE(copy.contains(removed));
  EXPECT_EQ(copy.chi2(edge), 2 * 16);
  EXPECT_EQ(copy.level(edge), 2);
  EXPECT_FALSE(copy.is_enabled(prior));
  EXPECT_EQ(copy.information(edge)(0, 0), 2);
  EXPECT_THAT(copy.vertices(edge), ElementsAre(VertexRef(a), VertexRef(b)));
  EXPECT_EQ(copy.all_edges(), graph.all_edges());
}

TEST(GraphCopy, ChangesIndependentlyOfItsOriginal) {
  Graph graph;
  const auto a = graph.add_vertex(1.0), b = graph.add_vertex(2.0);
  const auto edge = graph.add_edge(distance_of(5), a, b);
  Graph copy = graph;
  copy.set_estimate(b, 9.0);
  copy.set_measurement(edge, distance_of(8));
  copy.set_information(edge, 4.0);
  EXPECT_EQ(graph.estimate(b), 2);
  EXPECT_EQ(graph.chi2(edge), 16) << "the original's edge reads the original's vertices";
  EXPECT_EQ(copy.chi2(edge), 0);
  copy.remove(b);
  EXPECT_TRUE(graph.contains(b));
  EXPECT_TRUE(graph.contains(edge));
  const auto c = copy.add_vertex(3.0);
  EXPECT_EQ(copy.edges(c).size(), 0u);
  EXPECT_EQ(graph.edges(b).size(), 1u);
}

TEST(GraphCopy, RefusesHandlesThatItsOriginalCreatesLaterAndViceVersa) {
  Graph graph;
  const auto old = graph.add_vertex(1.0), removed = graph.add_vertex(2.0);
  graph.remove(removed);
  Graph copy = graph;
  EXPECT_TRUE(copy.contains(old));
  EXPECT_FALSE(copy.contains(removed));
  for (int i = 0; i < 3; ++i) {  // the first new vertex reuses the slot of `removed`
    const auto a = graph.add_vertex(3.0), b = copy.add_vertex(3.0);
    EXPECT_EQ(a.slot, b.slot);
    EXPECT_FALSE(copy.contains(a));
    EXPECT_FALSE(graph.contains(b));
    const auto e = graph.add_edge([](const auto& x) { return x; }, a);
    EXPECT_FALSE(copy.contains(e));
  }
}

TEST(GraphCopy, EvaluatesEdgesOverRangesAtItsOwnVertices) {
  Graph graph;
  const std::vector tail{graph.add_vertex(1.0), graph.add_vertex(2.0)};
  const auto edge = graph.add_edge(kSum, tail);
  Graph copy = graph;
  copy.set_estimate(tail[1], 10.0);
  EXPECT_EQ(copy.chi2(edge), 121);
  EXPECT_EQ(graph.chi2(edge), 9);
}

TEST(GraphCopy, SharesRobustKernelsWithItsOriginal) {
  Graph graph;
  const auto a = graph.add_vertex(1.0), b = graph.add_vertex(2.0);
  const auto edge = graph.add_edge(kDifference, a, b);
  graph.set_kernel(edge, Huber(1));
  auto copy = std::make_unique<Graph>(graph);
  EXPECT_EQ(copy->kernel(edge), graph.kernel(edge));
  copy.reset();
  EXPECT_EQ(graph.weight(edge), 1);
}

TEST(GraphCopy, CopiesTheStackOfPushedEstimates) {
  Graph graph;
  const auto a = graph.add_vertex(1.0);
  graph.push();
  graph.set_estimate(a, 2.0);
  Graph copy = graph;
  ASSERT_EQ(copy.stack_size(), 1);
  copy.pop();
  EXPECT_EQ(copy.estimate(a), 1);
  EXPECT_EQ(graph.estimate(a), 2);
  EXPECT_EQ(graph.stack_size(), 1);
}

TEST(GraphCopy, ReplacesTheGraphThatItIsAssignedTo) {
  Graph graph;
  const auto a = graph.add_vertex(1.0);
  Graph other;
  other.add_vertex(SE2(1, 2, 3), 5);
  other = graph;
  EXPECT_EQ(other.estimate(a), 1);
  EXPECT_EQ(other.find_vertex(5), std::nullopt);
  const Graph& same = graph;
  graph = same;
  EXPECT_EQ(graph.estimate(a), 1);
}

TEST(GraphCopy, OptimizesLikeItsOriginalWithoutChangingIt) {
  Graph graph;
  const auto a = graph.add_vertex(SE2(0, 0, 0)), b = graph.add_vertex(SE2(1, 0, 0.1)),
             c = graph.add_vertex(SE2(2, 1, 0));
  graph.add_edge(Between(SE2(1, 0.1, 0)), a, b);
  graph.add_edge(Between(SE2(1, 0, 0.2)), b, c);
  graph.add_edge(Between(SE2(2, 0.3, 0.1)), a, c);
  const SE2 at_b = graph.estimate(b), at_c = graph.estimate(c);
  Optimizer optimizer(graph);
  const Report first = optimizer.run();
  EXPECT_TRUE(first.converged());
  const SE2 best_b = graph.estimate(b), best_c = graph.estimate(c);
  graph.set_estimate(b, at_b);
  graph.set_estimate(c, at_c);
  Graph copy = graph;
  EXPECT_TRUE(optimize(copy).converged());
  EXPECT_EQ(copy.estimate(b).vector(), best_b.vector());
  EXPECT_EQ(copy.estimate(c).vector(), best_c.vector());
  EXPECT_EQ(graph.estimate(b).vector(), at_b.vector());
  EXPECT_TRUE(optimizer.run().plan_reused);
}

}  // namespace
}  // namespace boxplus
