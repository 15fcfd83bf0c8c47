// SPDX-License-Identifier: BSD-3-Clause
// Clients may remove a vertex from an active edge with Edge::setVertex() or Edge::vertices(), which do not
// notify the optimizer.
#include <gtest/gtest.h>

#include <string>

#include "g2o/core/optimization_algorithm_dogleg.h"
#include "g2o/core/small_graph.h"
#include "g2o/stuff/logger.h"

namespace {

using small_graph::make_solver;

/// An action that removes the first vertex of an edge when the action is called for the n-th time.
class TakeVertex : public g2o::HyperGraphAction {
 public:
  TakeVertex(g2o::HyperGraph::Edge& edge, int n, bool by_container)
      : edge_(&edge), left_(n), by_container_(by_container) {}
  HyperGraphAction* operator()(const g2o::HyperGraph*, Parameters*) override {
    if (--left_ != 0) return this;
    if (by_container_) {
      edge_->vertices()[0] = nullptr;
    } else {
      edge_->setVertex(0, nullptr);
    }
    return this;
  }

 private:
  g2o::HyperGraph::Edge* edge_;
  int left_;
  bool by_container_;
};

class LostVertex : public testing::Test {
 protected:
  void SetUp() override {
    g2o::logging::setSink([this](g2o::logging::Level level, const std::string& text) {
      messages += (level == g2o::logging::Level::kError ? "error: " : "") + text + "\n";
    });
    small_graph::add_square(optimizer);
    closure = small_graph::add_motion(optimizer, 0, 2, g2o::SE2(1.5, 0.7, 3));
    optimizer.setAlgorithm(new g2o::OptimizationAlgorithmLevenberg(make_solver()));
    ASSERT_TRUE(optimizer.initializeOptimization());
  }
  void TearDown() override { g2o::logging::setSink({}); }
  double chi2() {
    optimizer.computeActiveErrors();
    return optimizer.activeChi2();
  }

  g2o::SparseOptimizer optimizer;
  g2o::EdgeSE2* closure = nullptr;
  std::string messages;
};

TEST_F(LostVertex, ExcludesTheEdgeFromChi2) {
  const double with_edge = chi2();
  closure->setVertex(0, nullptr);
  const double without_edge = chi2();
  EXPECT_LT(without_edge, with_edge);
  EXPECT_EQ(optimizer.activeEdges().size(), 4U);
  // An error, because only errors reach stderr if the program has set no sink.
  EXPECT_EQ(messages, "error: number of edges that lost a vertex and are no longer active: 1\n");
  EXPECT_GT(optimizer.optimize(10), 0);
  EXPECT_LT(chi2(), without_edge);
}

TEST_F(LostVertex, BetweenTwoRunsIsReportedAndStopsTheSecondRun) {
  EXPECT_GT(optimizer.optimize(2), 0);
  closure->vertices()[0] = nullptr;
  EXPECT_EQ(optimizer.optimize(2), -1);
  EXPECT_NE(messages.find("lost a vertex"), std::string::npos);
  EXPECT_TRUE(optimizer.initializeOptimization());
  EXPECT_GT(optimizer.optimize(2), 0);
}

TEST_F(LostVertex, DuringAnIterationExcludesTheEdgeFromTheRestOfTheRun) {
  using Add = bool (g2o::SparseOptimizer::*)(g2o::HyperGraphAction*);
  const Add kinds[] = {&g2o::SparseOptimizer::addPreIterationAction,
                       &g2o::SparseOptimizer::addPostIterationAction,
                       &g2o::SparseOptimizer::addComputeErrorAction};
  for (const Add add : kinds) {
    for (int algorithm = 0; algorithm < 3; ++algorithm) {
      for (const bool by_container : {false, true}) {
        for (int call = 1; call <= 3; ++call) {
          g2o::SparseOptimizer o;
          small_graph::add_square(o);
          auto* edge = small_graph::add_motion(o, 0, 2, g2o::SE2(1.5, 0.7, 3));
          if (algorithm == 0) o.setAlgorithm(new g2o::OptimizationAlgorithmLevenberg(make_solver()));
          if (algorithm == 1) o.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(make_solver()));
          if (algorithm == 2) o.setAlgorithm(new g2o::OptimizationAlgorithmDogleg(make_solver()));
          ASSERT_TRUE(o.initializeOptimization());
          TakeVertex action(*edge, call, by_container);
          ASSERT_TRUE((o.*add)(&action));
          EXPECT_GT(o.optimize(20), 0);
          o.computeActiveErrors();
          EXPECT_EQ(o.activeEdges().size(), 4U);
          EXPECT_LT(o.activeChi2(), 0.1);
        }
      }
    }
  }
}

}  // namespace
