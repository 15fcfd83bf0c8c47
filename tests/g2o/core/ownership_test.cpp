// SPDX-License-Identifier: BSD-3-Clause
// Ownership of graph elements. Meant to run under AddressSanitizer.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "g2o/core/robust_kernel_factory.h"
#include "g2o/core/robust_kernel_impl.h"
#include "g2o/core/small_graph.h"

namespace {

using small_graph::add_square;
using small_graph::make_solver;

TEST(Ownership, RemovedElementsAreDeletedAndTheRestIsOptimized) {
  g2o::SparseOptimizer optimizer;
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmLevenberg(make_solver()));
  add_square(optimizer);
  auto* diagonal = small_graph::add_motion(optimizer, 0, 2, g2o::SE2(1, 1, 3));
  optimizer.initializeOptimization();
  optimizer.optimize(2);
  EXPECT_TRUE(optimizer.removeEdge(diagonal));
  EXPECT_EQ(optimizer.activeEdges().size(), 4u);
  EXPECT_TRUE(optimizer.removeVertex(optimizer.vertex(3)));
  EXPECT_EQ(optimizer.edges().size(), 2u);
  EXPECT_EQ(optimizer.optimize(1), -1) << "removing a vertex requires a new initialization";
  ASSERT_TRUE(optimizer.initializeOptimization());
  EXPECT_GT(optimizer.optimize(3), 0);
}

TEST(Ownership, TheGraphIsConsistentAfterVerticesAreMergedAndDetached) {
  g2o::SparseOptimizer optimizer;
  add_square(optimizer);
  EXPECT_TRUE(optimizer.mergeVertices(optimizer.vertex(1), optimizer.vertex(3), true));
  EXPECT_EQ(optimizer.vertices().size(), 3u);
  EXPECT_EQ(optimizer.edges().size(), 4u);
  EXPECT_EQ(optimizer.vertex(1)->edges().size(), 4u);
  EXPECT_TRUE(optimizer.detachVertex(optimizer.vertex(1)));
  for (const auto* e : optimizer.edges()) EXPECT_EQ(e->numUndefinedVertices(), 1);
  EXPECT_TRUE(optimizer.changeId(optimizer.vertex(1), 42));
  EXPECT_EQ(optimizer.vertex(1), nullptr);
  EXPECT_FALSE(optimizer.changeId(optimizer.vertex(42), 0));
}

TEST(Ownership, AClientMayOwnItsVertices) {
  std::vector<std::unique_ptr<g2o::VertexSE2>> mine;
  {
    g2o::SparseOptimizer optimizer;
    for (int i = 0; i < 3; ++i) {
      mine.push_back(std::make_unique<g2o::VertexSE2>());
      mine.back()->setId(i);
      optimizer.addVertex(mine.back().get());
    }
    small_graph::add_motion(optimizer, 0, 1, g2o::SE2(1, 0, 0));
    optimizer.vertices().clear();
    for (const auto& v : mine) v->edges().clear();
    optimizer.clear();
    EXPECT_TRUE(optimizer.edges().empty());
  }
  EXPECT_EQ(mine[2]->id(), 2);
}

TEST(Ownership, KernelsAlgorithmsAndGraphsAreDeletedThroughTheirBaseClasses) {
  std::unique_ptr<g2o::HyperGraph> graph = std::make_unique<g2o::SparseOptimizer>();
  auto* optimizer = static_cast<g2o::SparseOptimizer*>(graph.get());
  add_square(*optimizer);
  auto* e = static_cast<g2o::OptimizableGraph::Edge*>(*optimizer->edges().begin());
  e->setRobustKernel(new g2o::RobustKernelHuber);
  e->setRobustKernel(g2o::RobustKernelFactory::instance()->construct("Cauchy"));
  e->setRobustKernel(0);
  e->setRobustKernel(new g2o::RobustKernelTukey);
  optimizer->setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(make_solver()));
  optimizer->setAlgorithm(new g2o::OptimizationAlgorithmLevenberg(make_solver()));
  optimizer->initializeOptimization();
  optimizer->optimize(1);
}

/// An optimizer of a client, which reads and casts the protected member _algorithm.
class CustomOptimizer : public g2o::SparseOptimizer {
 public:
  double lambda() const {
    const auto* levenberg = dynamic_cast<g2o::OptimizationAlgorithmLevenberg*>(_algorithm);
    return levenberg == nullptr ? -1 : levenberg->currentLambda();
  }
};

TEST(Ownership, ADerivedOptimizerCanCastItsAlgorithm) {
  CustomOptimizer optimizer;
  EXPECT_EQ(optimizer.lambda(), -1);
  add_square(optimizer);
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmLevenberg(make_solver()));
  optimizer.initializeOptimization();
  optimizer.optimize(2);
  EXPECT_GT(optimizer.lambda(), 0);
}

TEST(Ownership, AnActionMayBeDestroyedBeforeTheOptimizer) {
  g2o::SparseOptimizer optimizer;
  add_square(optimizer);
  {
    g2o::HyperGraphAction action;
    optimizer.addPostIterationAction(&action);
  }
  optimizer.clear();
}

TEST(Ownership, ElementsOutsideOfAGraphDeleteTheirKernelsAndData) {
  struct Note : g2o::HyperGraph::Data {
    bool read(std::istream&) override { return true; }
    bool write(std::ostream&) const override { return true; }
  };
  g2o::VertexSE2 v;
  v.addUserData(new Note);
  v.addUserData(new Note);
  EXPECT_NE(v.userData()->next(), nullptr);
  g2o::EdgeSE2 e;
  e.setRobustKernel(new g2o::RobustKernelDCS);
}

}  // namespace
