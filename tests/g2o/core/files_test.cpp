// SPDX-License-Identifier: BSD-3-Clause
// What .g2o files may hold beside complete lines in order.
#include <gmock/gmock.h>

#include <sstream>
#include <string>
#include <vector>

#include "g2o/core/factory.h"
#include "g2o/core/small_graph.h"
#include "g2o/stuff/logger.h"

G2O_USE_TYPE_GROUP(slam2d);

namespace {

const char* const kUnassigned =
    "PARAMS_SE2OFFSET 3 1 1 0\n"
    "VERTEX_SE2 0 0 0 0\n"
    "FIX 0\n"
    "VERTEX_SE2 1 1 0 0.5\n"
    "VERTEX_XY 2 3 1\n"
    "EDGE_SE2 0 1 1 0 0.25 1 0 0 1 0 1\n"
    "EDGE_SE2_XY 0 -1 0.5 0.5 20 0 20\n"
    "EDGE_SE2_POINTXY_OFFSET 1 -1 3 1 0 1 0 1\n";

TEST(Files, EdgesWithUnassignedVerticesAreKeptAndSavedAndTakeNoPart) {
  g2o::SparseOptimizer optimizer;
  std::istringstream in(kUnassigned);
  ASSERT_TRUE(optimizer.load(in));
  EXPECT_EQ(optimizer.edges().size(), 3u);
  EXPECT_EQ(optimizer.vertex(0)->edges().size(), 2u);
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(small_graph::make_solver()));
  ASSERT_TRUE(optimizer.initializeOptimization());
  EXPECT_EQ(optimizer.activeEdges().size(), 1u);
  optimizer.computeActiveErrors();
  EXPECT_EQ(optimizer.chi2(), optimizer.activeChi2());
  std::ostringstream out;
  ASSERT_TRUE(optimizer.save(out));
  EXPECT_EQ(out.str(), kUnassigned);
}

TEST(Files, AnUnassignedEdgeTakesPartOnceItIsGivenItsVertex) {
  g2o::SparseOptimizer optimizer;
  std::istringstream in(kUnassigned);
  ASSERT_TRUE(optimizer.load(in));
  std::vector<g2o::OptimizableGraph::Edge*> unassigned;
  for (g2o::HyperGraph::Edge* e : optimizer.edges()) {
    if (e->numUndefinedVertices() > 0) unassigned.push_back(static_cast<g2o::OptimizableGraph::Edge*>(e));
  }
  ASSERT_EQ(unassigned.size(), 2u);
  for (auto* e : unassigned) {
    EXPECT_FALSE(optimizer.setEdgeVertex(e, 1, optimizer.vertex(e->vertex(0)->id() == 0 ? 1 : 0)))
        << "a pose is no point";
    EXPECT_EQ(e->vertex(1), nullptr);
    EXPECT_TRUE(optimizer.setEdgeVertex(e, 1, optimizer.vertex(2)));
  }
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(small_graph::make_solver()));
  ASSERT_TRUE(optimizer.initializeOptimization());
  EXPECT_EQ(optimizer.activeEdges().size(), 3u);
  EXPECT_EQ(optimizer.optimize(2), 2);
}

TEST(Files, AnUnassignedEdgeIsRefusedWhereItsOtherVerticesDoNotFit) {
  g2o::SparseOptimizer optimizer;
  small_graph::add_pose(optimizer, 0, 0, 0, 0);
  auto e = std::make_unique<g2o::EdgeSE2PointXY>();
  e->setVertex(1, optimizer.vertex(0));
  EXPECT_FALSE(optimizer.addUnassignedEdge(e.get()));
  g2o::VertexSE2 stranger;
  stranger.setId(0);
  e->setVertex(0, &stranger);
  e->setVertex(1, nullptr);
  EXPECT_FALSE(optimizer.addUnassignedEdge(e.get()));
  EXPECT_TRUE(optimizer.edges().empty());
}

TEST(Files, ALineWithMoreFieldsThanItsTypeHasIsRefused) {
  std::vector<std::string> messages;
  g2o::logging::setSink([&](g2o::logging::Level, const std::string& text) { messages.push_back(text); });
  for (const std::string line : {"PARAMS_SE2OFFSET 3 1 1 0 7", "VERTEX_XY 6 1 0 7",
                                 "EDGE_SE2 0 5 1 0 0 1 0 0 1 0 1 7", "FIX 0 seven"}) {
    SCOPED_TRACE(line);
    g2o::SparseOptimizer optimizer;
    messages.clear();
    std::istringstream file("VERTEX_SE2 0 0 0 0\nVERTEX_SE2 5 1 0 0\n" + line + "\n");
    EXPECT_FALSE(optimizer.load(file));
    EXPECT_THAT(messages, testing::ElementsAre(testing::AllOf(testing::HasSubstr("line 3"),
                                                              testing::HasSubstr("expected the end"))));
    EXPECT_EQ(optimizer.vertices().size(), 2u);
    EXPECT_TRUE(optimizer.edges().empty());
  }
  g2o::logging::setSink({});
}

TEST(Files, ALineMayEndWithACommentOrACarriageReturn) {
  g2o::SparseOptimizer optimizer;
  std::istringstream file("VERTEX_SE2 0 0 0 0 # the start\nVERTEX_XY 6 1 0\r\nFIX 0 # it stays\n");
  EXPECT_TRUE(optimizer.load(file));
  EXPECT_EQ(optimizer.vertices().size(), 2u);
}

}  // namespace
