// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "g2o/edge_checks.h"
#include "g2o/types/slam2d/types_slam2d.h"

G2O_USE_TYPE_GROUP(slam2d);

namespace {

using edge_checks::omega;

/// A vertex of an older client, which overrides oplusImpl(double*).
class NonConstPoint : public g2o::VertexPointXY {
 public:
  int calls = 0;

 protected:
  void oplusImpl(double* update) override {
    ++calls;
    g2o::VertexPointXY::oplusImpl(update);
  }
};

/// A vertex of a newer client, which overrides oplusImpl(const double*).
class ConstPoint : public g2o::VertexPointXY {
 public:
  int calls = 0;

 protected:
  void oplusImpl(const double* update) override {
    ++calls;
    g2o::VertexPointXY::oplusImpl(update);
  }
};

template <typename Point>
void expect_oplus_of_the_subclass() {
  Point point;
  point.setEstimate(g2o::Vector2(1, 2));
  const double update[] = {0.5, -1};
  point.oplus(update);
  EXPECT_EQ(point.calls, 1);
  EXPECT_EQ(point.estimate(), g2o::Vector2(1.5, 1));
}

TEST(Slam2d, AllTypesHaveExactJacobiansAndAreWrittenAsTheyWereRead) {
  edge_checks::expect_laws_of_file(
      "PARAMS_SE2OFFSET 0 0.1 0.2 0.3\n"
      "PARAMS_SE2OFFSET 1 -0.3 0.1 1.2\n"
      "VERTEX_SE2 0 1 2 0.5\n"
      "VERTEX_SE2 1 3 1 -0.7\n"
      "VERTEX_SE2 2 0.2 -0.1 0.3\n"
      "VERTEX_XY 3 4 5\n"
      "VERTEX_XY 4 -1 2\n"
      "EDGE_SE2 0 1 2 0.3 -1" +
      omega(3) +
      "\n"
      "EDGE_SE2_XY 0 3 3 2" +
      omega(2) +
      "\n"
      "EDGE_BEARING_SE2_XY 0 3 0.4" +
      omega(1) +
      "\n"
      "EDGE_PRIOR_SE2 1 3.1 0.9 -0.6" +
      omega(3) +
      "\n"
      "EDGE_PRIOR_SE2_XY 1 3.1 0.9" +
      omega(2) +
      "\n"
      "EDGE_PRIOR_XY 3 4.1 4.9" +
      omega(2) +
      "\n"
      "EDGE_POINTXY 3 4 -5.1 -3.1" +
      omega(2) +
      "\n"
      "EDGE_SE2_XY_CALIB 0 3 2 3 1" +
      omega(2) +
      "\n"
      "EDGE_SE2_OFFSET 0 1 0 1 2 0.3 -1" +
      omega(3) +
      "\n"
      "EDGE_SE2_POINTXY_OFFSET 0 4 1 3 2" +
      omega(2) +
      "\n"
      "EDGE_SE2_TWOPOINTSXY 0 3 4 3 2 -2 1" +
      omega(4) +
      "\n"
      "EDGE_SE2_LOTSOFXY 1 4 3 || 2 3 2 -2 1" +
      omega(4) + "\n");
}

TEST(Slam2d, AnEdgeToManyPointsHasTheSameErrorAsOneEdgeForEachPoint) {
  g2o::SparseOptimizer optimizer;
  std::istringstream in(
      "VERTEX_SE2 0 1 2 0.5\nVERTEX_XY 1 4 5\nVERTEX_XY 2 -1 2\nVERTEX_XY 3 2 2\n"
      "EDGE_SE2_LOTSOFXY 0 1 2 3 || 3 1 2 3 4 5 6" +
      omega(6) +
      "\n"
      "EDGE_SE2_XY 0 2 3 4" +
      omega(2) + "\n");
  ASSERT_TRUE(optimizer.load(in));
  const g2o::EdgeSE2LotsOfXY* lots = nullptr;
  const g2o::EdgeSE2PointXY* one = nullptr;
  for (g2o::HyperGraph::Edge* e : optimizer.edges()) {
    static_cast<g2o::OptimizableGraph::Edge*>(e)->computeError();
    if (const auto* x = dynamic_cast<g2o::EdgeSE2LotsOfXY*>(e)) lots = x;
    if (const auto* x = dynamic_cast<g2o::EdgeSE2PointXY*>(e)) one = x;
  }
  ASSERT_TRUE(lots != nullptr && one != nullptr);
  EXPECT_EQ(lots->error().size(), 6);
  EXPECT_EQ((lots->error().segment<2>(2)), one->error());
}

TEST(Slam2d, AnEdgeToManyPointsRefusesAWrongNumberOrTypeOfVertices) {
  for (const char* line :
       {"EDGE_SE2_LOTSOFXY 0 1 2 || 1 1 2 1 0 1\n", "EDGE_SE2_LOTSOFXY 0 1 || 2 1 2 3 4 1 0 1\n",
        "EDGE_SE2_LOTSOFXY 1 0 || 1 1 2 1 0 1\n", "EDGE_SE2_LOTSOFXY 0 1 || 1 1\n"}) {
    SCOPED_TRACE(line);
    g2o::SparseOptimizer optimizer;
    std::istringstream in(std::string("VERTEX_SE2 0 1 2 0.5\nVERTEX_XY 1 4 5\nVERTEX_XY 2 -1 2\n") + line);
    EXPECT_FALSE(optimizer.load(in));
    EXPECT_TRUE(optimizer.edges().empty());
  }
}

TEST(Slam2d, AnEdgeToManyFixedPointsDeterminesItsPose) {
  g2o::SparseOptimizer optimizer;
  std::istringstream in(
      "VERTEX_SE2 0 0.1 0.2 0.1\nVERTEX_XY 1 4 5\nVERTEX_XY 2 -1 2\nFIX 1 2\n"
      "EDGE_SE2_LOTSOFXY 0 1 2 || 2 4 5 -1 2" +
      omega(4) + "\n");
  ASSERT_TRUE(optimizer.load(in));
  auto* pose = static_cast<g2o::VertexSE2*>(optimizer.vertex(0));
  for (int i = 0; i < 10; ++i) {
    auto* e = static_cast<g2o::OptimizableGraph::Edge*>(*optimizer.edges().begin());
    ASSERT_TRUE(optimizer.jacobianWorkspace().allocate());
    double hessian[9] = {};
    pose->mapHessianMemory(hessian);
    pose->clearQuadraticForm();
    e->computeError();
    e->linearizeOplus(optimizer.jacobianWorkspace());
    e->constructQuadraticForm();
    pose->solveDirect();
  }
  EXPECT_LT(pose->estimate().toVector().norm(), 1e-9);
}

TEST(Slam2d, ASubclassOfALibraryVertexMayOverrideEitherOverloadOfOplusImpl) {
  expect_oplus_of_the_subclass<NonConstPoint>();
  expect_oplus_of_the_subclass<ConstPoint>();
}

}  // namespace
