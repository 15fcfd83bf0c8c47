// SPDX-License-Identifier: BSD-3-Clause
// Tests the types in examples/tutorial_slam2d: group laws, Jacobians, files.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <sstream>
#include <string>

#include "edge_se2.h"
#include "edge_se2_point_xy.h"
#include "g2o/core/factory.h"
#include "g2o/core/sparse_optimizer.h"

G2O_USE_TYPE_GROUP(tutorial_slam2d);

namespace {

using namespace g2o;
using namespace g2o::tutorial;

constexpr const char* kGraph =
    "TUTORIAL_PARAMS_SE2_OFFSET 0 0.2 0.1 -0.3\n"
    "TUTORIAL_VERTEX_SE2 0 0 0 0\n"
    "FIX 0\n"
    "TUTORIAL_VERTEX_SE2 1 1.1 0.25 3\n"
    "TUTORIAL_VERTEX_POINT_XY 2 -1.5 0.75\n"
    "TUTORIAL_EDGE_SE2 0 1 1 0.3 3.1 10 1 0 20 0 30 \n"
    "TUTORIAL_EDGE_SE2_POINT_XY 1 2 0 2.5 -0.1 5 1 6 \n";

bool load(OptimizableGraph& graph, const std::string& text) {
  std::istringstream in(text);
  return graph.load(in);
}

EdgeSE2PointXY* landmark_edge(OptimizableGraph& graph) {
  for (HyperGraph::Edge* e : graph.edges())
    if (auto* found = dynamic_cast<EdgeSE2PointXY*>(e)) return found;
  return nullptr;
}

void expect_equal(const SE2& a, const SE2& b) {
  EXPECT_LT((a.toVector() - b.toVector()).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(TutorialTypes, MotionsFormAGroup) {
  const SE2 a(1, -2, 3), b(0.5, 0.25, 0.5), c(-3, 1, -2);
  expect_equal(a * (b * c), (a * b) * c);
  expect_equal(a * a.inverse(), SE2());
  expect_equal(SE2() * a, a);
  EXPECT_LT(((a * b) * Vector2(4, 5) - a * (b * Vector2(4, 5))).norm(), 1e-12);
  SE2 copy;
  copy.fromVector(a.toVector());
  expect_equal(copy, a);
}

TEST(TutorialTypes, AStepOfAPoseIsAMotionInItsBodyFrame) {
  VertexSE2 v;
  v.setEstimate(SE2(1, 2, M_PI / 2));
  const double nothing[] = {0, 0, 0}, ahead[] = {1, 0, 0}, turn[] = {0, 0, M_PI};
  v.oplus(nothing);
  expect_equal(v.estimate(), SE2(1, 2, M_PI / 2));
  v.oplus(ahead);
  expect_equal(v.estimate(), SE2(1, 3, M_PI / 2));
  v.oplus(turn);  // the angle exceeds π and is wrapped
  expect_equal(v.estimate(), SE2(1, 3, -M_PI / 2));
  v.setToOrigin();
  expect_equal(v.estimate(), SE2());
}

TEST(TutorialTypes, AFileIsWrittenAsItWasRead) {
  OptimizableGraph graph;
  ASSERT_TRUE(load(graph, kGraph));
  std::ostringstream out;
  ASSERT_TRUE(graph.save(out));
  EXPECT_EQ(out.str(), kGraph);
}

TEST(TutorialTypes, EachTagConstructsItsType) {
  for (const char* tag : {"TUTORIAL_VERTEX_SE2", "TUTORIAL_VERTEX_POINT_XY", "TUTORIAL_PARAMS_SE2_OFFSET",
                          "TUTORIAL_CACHE_SE2_OFFSET", "TUTORIAL_EDGE_SE2", "TUTORIAL_EDGE_SE2_POINT_XY"}) {
    const std::unique_ptr<HyperGraph::HyperGraphElement> element(Factory::instance()->construct(tag));
    ASSERT_NE(element, nullptr) << tag;
    EXPECT_EQ(Factory::instance()->tag(element.get()), tag);
  }
}

TEST(TutorialTypes, IncompleteLinesAndUnknownParametersAreRefused) {
  for (const char* line :
       {"TUTORIAL_VERTEX_SE2 7 1 2\n", "TUTORIAL_VERTEX_POINT_XY 7 1\n", "TUTORIAL_PARAMS_SE2_OFFSET 7 1 2\n",
        "TUTORIAL_EDGE_SE2 0 1 1 0.3 3.1 10 1 0 20 0\n", "TUTORIAL_EDGE_SE2_POINT_XY 1 2 0 2.5\n",
        "TUTORIAL_EDGE_SE2_POINT_XY 1 2 99 1 1 1 0 1\n"}) {
    OptimizableGraph graph;
    EXPECT_FALSE(load(graph, std::string(kGraph) + line)) << line;
  }
}

TEST(TutorialTypes, TheErrorOfALandmarkEdgeDependsOnTheMountingPoseOfTheSensor) {
  OptimizableGraph graph;
  ASSERT_TRUE(load(graph, kGraph));
  EdgeSE2PointXY* e = landmark_edge(graph);
  ASSERT_NE(e, nullptr);
  const auto error = [&](const SE2& robot) {
    const SE2 sensor = robot * SE2(0.2, 0.1, -0.3);
    return Vector2(sensor.inverse() * Vector2(-1.5, 0.75) - Vector2(2.5, -0.1));
  };
  e->computeError();
  EXPECT_LT((e->error() - error(SE2(1.1, 0.25, 3))).norm(), 1e-12);
  // The cache must be updated after every change of the estimate.
  auto* robot = static_cast<VertexSE2*>(graph.vertex(1));
  robot->push();
  robot->setEstimate(SE2(2, 1, 0));
  e->computeError();
  EXPECT_LT((e->error() - error(SE2(2, 1, 0))).norm(), 1e-12);
  robot->pop();
  const double step[] = {0.1, 0.2, 0.3};
  robot->oplus(step);
  e->computeError();
  EXPECT_LT((e->error() - error(SE2(1.1, 0.25, 3) * SE2(0.1, 0.2, 0.3))).norm(), 1e-12);
}

TEST(TutorialTypes, TheJacobiansOfALandmarkEdgeMatchCentralDifferences) {
  OptimizableGraph graph;
  ASSERT_TRUE(load(graph, kGraph));
  EdgeSE2PointXY* e = landmark_edge(graph);
  ASSERT_NE(e, nullptr);
  JacobianWorkspace workspace;
  workspace.updateSize(e);
  workspace.allocate();
  static_cast<OptimizableGraph::Edge*>(e)->linearizeOplus(workspace);
  const Eigen::Matrix<double, 2, 3> analytic_pose = e->jacobianOplusXn<0>();
  const Matrix2 analytic_point = e->jacobianOplusXn<1>();
  for (const int i : {0, 1}) {
    auto* v = static_cast<OptimizableGraph::Vertex*>(e->vertices()[static_cast<size_t>(i)]);
    for (int k = 0; k < v->dimension(); ++k) {
      Vector2 at[2];
      for (const int side : {0, 1}) {
        double step[3] = {};
        step[k] = side == 0 ? -1e-6 : 1e-6;
        v->push();
        v->oplus(step);
        e->computeError();
        at[side] = e->error();
        v->pop();
      }
      const Vector2 numeric = (at[1] - at[0]) / 2e-6;
      const Vector2 analytic = i == 0 ? Vector2(analytic_pose.col(k)) : Vector2(analytic_point.col(k));
      EXPECT_LT((numeric - analytic).norm(), 1e-8) << "vertex " << i << ", direction " << k;
    }
  }
}

TEST(TutorialTypes, AnEdgeWithoutItsParameterIsRefused) {
  OptimizableGraph graph;
  ASSERT_TRUE(load(graph, kGraph));
  auto e = std::make_unique<EdgeSE2PointXY>();
  e->setVertex(0, graph.vertex(0));
  e->setVertex(1, graph.vertex(2));
  e->setParameterId(0, 99);
  EXPECT_FALSE(graph.addEdge(e.get()));
  e->setParameterId(0, 0);
  EXPECT_TRUE(graph.addEdge(e.release()));
}

}  // namespace
