// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/cut_off.h"

#include <gtest/gtest.h>

#include "optimize/small_graphs.h"

namespace boxplus {
namespace {

/// A chain of poses 0 – 1 – … – 5, as edges 0 to 4.
class CutOff : public ::testing::Test {
 protected:
  CutOff() {
    for (int k = 0; k < 6; ++k) poses.push_back(graph.add_vertex(SE2(k, 0, 0)));
    for (std::size_t k = 0; k + 1 < poses.size(); ++k) link(k, k + 1);
  }

  EdgeRef link(std::size_t a, std::size_t b) {
    return graph.add_edge(Between(SE2(1, 0, 0)), poses[a], poses[b]);
  }

  /// The ids of the result if these edges are rejected. The numbers are those of the plan.
  std::vector<Id> cut_off_without(std::initializer_list<std::size_t> edges,
                                  GaugePolicy gauge = GaugePolicy::kFixFirst) {
    const Plan plan = make_plan(graph, {.gauge = gauge});
    std::vector<std::uint8_t> rejected(plan.edge_count, 0);
    for (const std::size_t edge : edges) rejected[edge] = 1;
    std::vector<Id> ids;
    for (const VertexRef& vertex : find_cut_off(graph, plan, rejected)) ids.push_back(graph.id(vertex));
    return ids;
  }

  using Ids = std::vector<Id>;
  Graph graph;
  std::vector<VertexHandle<SE2>> poses;
};

TEST_F(CutOff, ListsThePartsThatOnlyRejectedEdgesTieToAFixedVertex) {
  graph.fix(poses[0]);
  EXPECT_EQ(cut_off_without({}), Ids{});
  EXPECT_EQ(cut_off_without({2}), Ids{3});
  EXPECT_EQ(cut_off_without({1, 3}), (Ids{2, 4}));
}

TEST_F(CutOff, IgnoresRejectedEdgesWhoseVerticesOtherEdgesConnect) {
  graph.fix(poses[0]);
  link(1, 4);  // edge 5
  EXPECT_EQ(cut_off_without({5}), Ids{});
  EXPECT_EQ(cut_off_without({2}), Ids{});
  EXPECT_EQ(cut_off_without({2, 5}), Ids{3});
}

TEST_F(CutOff, CountsAHeldVertexAsFixed) {
  EXPECT_EQ(cut_off_without({0}), Ids{1});
}

TEST_F(CutOff, CountsTheLargestPartAsFixedIfNothingIs) {
  EXPECT_EQ(cut_off_without({1}, GaugePolicy::kDamp), Ids{0});
  EXPECT_EQ(cut_off_without({3}, GaugePolicy::kDamp), Ids{4});
}

TEST_F(CutOff, ListsAComponentThatOnlyRejectedPriorsFix) {
  graph.add_edge(Prior(SE2(0, 0, 0)), poses[0]);  // edges 5 and 6 of the plan
  graph.add_edge(Prior(SE2(5, 0, 0)), poses[5]);
  EXPECT_EQ(cut_off_without({5}), Ids{});
  EXPECT_EQ(cut_off_without({5, 6}), Ids{0});
}

TEST_F(CutOff, DoesNotListAPartThatOnlyDisabledEdgesHold) {
  graph.fix(poses[0]);
  graph.set_enabled(graph.all_edges()[2], false);
  EXPECT_EQ(cut_off_without({}), Ids{});
  EXPECT_EQ(cut_off_without({4}), Ids{5});
}

TEST_F(CutOff, DoesNotCountAParameterAsFixed) {
  graph.fix(poses[0]);
  poses.push_back(graph.add_vertex(SE2(6, 0, 0)));
  const auto last = graph.add_vertex(7.0);
  const auto scale = graph.add_parameter(1.0);
  link(5, 6);
  graph.add_edge([](const auto& pose, const auto& x, const auto& s) { return s * x - pose.x(); }, poses[6],
                 last, scale);
  EXPECT_EQ(cut_off_without({5}), Ids{6});  // with the last vertex, which has the id 7
}

}  // namespace
}  // namespace boxplus
