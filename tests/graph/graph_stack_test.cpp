// SPDX-License-Identifier: BSD-3-Clause
// push(), pop() and discard_top().
#include <gtest/gtest.h>

#include <array>
#include <memory>

#include "boxplus/graph/graph.h"
#include "boxplus/manifold/rn.h"

namespace boxplus {
namespace {

TEST(GraphStack, PopRestoresTheEstimatesThatPushSaved) {
  Graph graph;
  const auto a = graph.add_vertex(1.0);
  const auto b = graph.add_vertex(Eigen::Vector2d(1, 2));
  graph.push();
  graph.set_estimate(a, 5.0);
  graph.set_estimate(b, Eigen::Vector2d(7, 8));
  EXPECT_EQ(graph.stack_size(), 1);
  graph.pop();
  EXPECT_EQ(graph.estimate(a), 1);
  EXPECT_EQ(graph.estimate(b), Eigen::Vector2d(1, 2));
  EXPECT_EQ(graph.stack_size(), 0);
}

TEST(GraphStack, PushesMayBeNested) {
  Graph graph;
  const auto a = graph.add_vertex(1.0);
  graph.push();
  graph.set_estimate(a, 2.0);
  graph.push();
  graph.set_estimate(a, 3.0);
  graph.push();
  graph.set_estimate(a, 4.0);
  graph.discard_top();
  EXPECT_EQ(graph.estimate(a), 4);
  graph.pop();
  EXPECT_EQ(graph.estimate(a), 2);
  graph.pop();
  EXPECT_EQ(graph.estimate(a), 1);
}

TEST(GraphStack, PopRestoresOnlyTheVerticesThatPushWasCalledFor) {
  Graph graph;
  const auto a = graph.add_vertex(1.0), b = graph.add_vertex(2.0);
  graph.push(std::array<VertexRef, 1>{b});
  graph.set_estimate(a, 5.0);
  graph.set_estimate(b, 6.0);
  graph.pop();
  EXPECT_EQ(graph.estimate(a), 5);
  EXPECT_EQ(graph.estimate(b), 2);
}

TEST(GraphStack, PopSkipsVerticesThatWereAddedAfterPush) {
  Graph graph;
  const auto a = graph.add_vertex(1.0);
  graph.push();
  const auto b = graph.add_vertex(2.0);
  const auto c = graph.add_vertex(Eigen::Vector2d(1, 2));
  graph.push();
  graph.set_estimate(a, 5.0);
  graph.set_estimate(b, 6.0);
  graph.pop();
  EXPECT_EQ(graph.estimate(b), 2);
  graph.set_estimate(a, 5.0);
  graph.set_estimate(b, 7.0);
  graph.pop();
  EXPECT_EQ(graph.estimate(a), 1);
  EXPECT_EQ(graph.estimate(b), 7);
  EXPECT_EQ(graph.estimate(c), Eigen::Vector2d(1, 2));
}

TEST(GraphStack, PopSkipsRemovedVerticesEvenIfTheirSlotIsReused) {
  Graph graph;
  const auto a = graph.add_vertex(1.0), b = graph.add_vertex(2.0);
  graph.push();
  graph.remove(a);
  const auto c = graph.add_vertex(3.0);
  EXPECT_EQ(c.slot, a.slot);
  graph.set_estimate(b, 9.0);
  graph.pop();
  EXPECT_EQ(graph.estimate(c), 3);
  EXPECT_EQ(graph.estimate(b), 2);
}

TEST(GraphStack, PushSavesParametersToo) {
  Graph graph;
  const auto offset = graph.add_parameter(1.0);
  graph.push();
  graph.set_estimate(offset, 2.0);
  graph.pop();
  EXPECT_EQ(graph.estimate(offset), 1);
}

TEST(GraphStack, AnEmptyStackCannotBePopped) {
  Graph graph;
  EXPECT_THROW(graph.pop(), InvalidArgument);
  EXPECT_THROW(graph.discard_top(), InvalidArgument);
}

TEST(GraphStack, AStaleHandleCannotBePushed) {
  Graph graph;
  const auto a = graph.add_vertex(1.0);
  graph.remove(a);
  EXPECT_THROW(graph.push(std::array<VertexRef, 1>{a}), InvalidArgument);
  EXPECT_EQ(graph.stack_size(), 0);
}

TEST(GraphStack, PopAdvancesTheRevisionIfItRestoresTheSizeOfAVertex) {
  Graph graph;
  const auto a = graph.add_vertex(Eigen::VectorXd::Zero(2).eval());
  graph.push();
  graph.set_estimate(a, Eigen::VectorXd::Zero(5).eval());
  const auto revision = graph.revision();
  graph.pop();
  EXPECT_EQ(graph.tangent_dim(a), 2);
  EXPECT_NE(graph.revision(), revision);
}

TEST(SavedEstimates, StayTheSameWhenTheEstimatesInThePoolChange) {
  detail::TypedVertexPool<double> pool;
  const std::uint32_t a = pool.add(1.0, 0), b = pool.add(2.0, 1);
  std::unique_ptr<detail::SavedEstimates> both, last;
  pool.save(std::array{a, b}, both);
  pool.value(a) = 5.0;
  pool.value(b) = 6.0;
  pool.save(std::array{b}, last);
  const std::unique_ptr<detail::SavedEstimates> copy = both->clone();
  pool.save(std::array{b}, both);  // now `both` contains only the estimate of b
  pool.restore(std::array{detail::VertexPool::kNoSlot, b}, *copy);
  EXPECT_EQ(pool.value(a), 5);
  EXPECT_EQ(pool.value(b), 2);
  pool.restore(std::array{a}, *both);
  EXPECT_EQ(pool.value(a), 6);
  pool.restore(std::array{b}, *last);
  EXPECT_EQ(pool.value(b), 6);
}

}  // namespace
}  // namespace boxplus
