// SPDX-License-Identifier: BSD-3-Clause
// Runs whose robust kernels reject edges that the result needs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "optimize/small_graphs.h"

namespace boxplus {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A chain of 10 exact poses, and some measurements to the first pose.
class Rejection : public ::testing::Test {
 protected:
  Rejection() {
    for (int k = 0; k < 10; ++k) poses.push_back(graph.add_vertex(SE2(k, 0, 0)));
    for (std::size_t k = 0; k + 1 < poses.size(); ++k)
      chain.push_back(graph.add_edge(Between(SE2(1, 0, 0)), poses[k], poses[k + 1]));
    graph.fix(poses[0]);
  }

  /// Adds an edge that is wrong by `wrong` meters, from the first pose.
  EdgeRef close(std::size_t to, double wrong, const std::shared_ptr<const RobustKernel>& kernel) {
    const EdgeRef edge =
        graph.add_edge(Between(SE2(static_cast<double>(to) + wrong, 0, 0)), poses[0], poses[to]);
    graph.set_kernel(edge, kernel);
    return edge;
  }

  Graph graph;
  std::vector<VertexHandle<SE2>> poses;
  std::vector<EdgeRef> chain;
  std::shared_ptr<const RobustKernel> tukey = std::make_shared<Tukey>(2), huber = std::make_shared<Huber>(2);
};

TEST_F(Rejection, OfMoreThanHalfOfTheEdgesWithRedescendingKernelsIsNoConvergence) {
  for (const std::size_t to : {3, 4, 5}) close(to, 50, tukey);
  close(6, 0, tukey);
  const Report report = optimize(graph);
  EXPECT_EQ(report.status, Report::Status::kNotConverged);
  EXPECT_EQ(report.reason, Report::Reason::kRejectedEdges);
  EXPECT_TRUE(report.rejection.is_known);
  EXPECT_EQ(report.rejection.edges, 3u);
  EXPECT_EQ(report.rejection.redescending, 4u);
  EXPECT_EQ(report.rejection.by_redescending, 3u);
  EXPECT_THAT(report.rejection.cut_off, IsEmpty());
  EXPECT_THAT(report.message, HasSubstr("3 of the 4 edges with redescending kernels; try another start"));
  EXPECT_THAT(to_string(report),
              HasSubstr("rejected 3 of 13 edges (weight below 0.001); 4 edges have a kernel"));
}

TEST_F(Rejection, OfHalfOfTheEdgesIsNoReasonToDoubtTheResult) {
  for (const std::size_t to : {3, 4}) close(to, 50, tukey);
  for (const std::size_t to : {5, 6}) close(to, 0, tukey);
  const Report report = optimize(graph);
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_EQ(report.rejection.edges, 2u);
  EXPECT_THAT(report.rejection.cut_off, IsEmpty());
}

TEST_F(Rejection, ByAKernelThatKeepsItsInfluenceIsCountedOnly) {
  for (const std::size_t to : {3, 4, 5}) close(to, 1e5, huber);
  const Report report = optimize(graph);
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_EQ(report.robust_edges, 3u);
  EXPECT_EQ(report.rejection.edges, 3u);
  EXPECT_EQ(report.rejection.redescending, 0u);
}

TEST_F(Rejection, OfTheOnlyEdgeThatHoldsAPartIsNoConvergence) {
  for (const EdgeRef& edge : chain) graph.set_kernel(edge, tukey);
  for (std::size_t k = 6; k < poses.size(); ++k)
    graph.set_estimate(poses[k], SE2(100 + static_cast<double>(k), 0, 0));
  const Report report = optimize(graph);
  EXPECT_EQ(report.reason, Report::Reason::kRejectedEdges);
  EXPECT_THAT(report.rejection.cut_off, ElementsAre(6));
  EXPECT_THAT(report.message, HasSubstr("nothing else holds the part with vertex 6; try another start"));
}

TEST_F(Rejection, IsNotKnownIfEdgesHaveNoKernelsOrTheRunIsStopped) {
  EXPECT_FALSE(optimize(graph).rejection.is_known);
  close(5, 50, tukey);
  const Report report = optimize(graph, {.time_limit_s = 0});
  EXPECT_EQ(report.reason, Report::Reason::kTimeLimit);
  EXPECT_FALSE(report.rejection.is_known);
  EXPECT_THAT(to_string(report), testing::Not(HasSubstr("rejected")));
}

TEST_F(Rejection, DoesNotChangeTheReasonOfARunThatDidNotConverge) {
  for (const std::size_t to : {3, 4, 5}) close(to, 50, tukey);
  const Report report = optimize(graph, {.max_iterations = 0});
  EXPECT_EQ(report.reason, Report::Reason::kMaxIterations);
  EXPECT_EQ(report.rejection.edges, 3u);
}

}  // namespace
}  // namespace boxplus
