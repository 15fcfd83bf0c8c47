// SPDX-License-Identifier: BSD-3-Clause
// A client in C++14 that forgets to call setParameterId().
#include <memory>

#include "g2o/core/block_solver.h"
#include "g2o/core/factory.h"
#include "g2o/core/optimization_algorithm_levenberg.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/solvers/eigen/linear_solver_eigen.h"
#include "g2o/types/slam3d/types_slam3d.h"

int main() {
  typedef g2o::BlockSolver<g2o::BlockSolverTraits<6, 3>> Blocks;
  g2o::SparseOptimizer optimizer;
  std::unique_ptr<Blocks::LinearSolverType> linear(new g2o::LinearSolverEigen<Blocks::PoseMatrixType>());
  optimizer.setAlgorithm(
      new g2o::OptimizationAlgorithmLevenberg(std::unique_ptr<Blocks>(new Blocks(std::move(linear)))));
  for (int id = 0; id < 2; ++id) {
    g2o::VertexSE3* v = new g2o::VertexSE3;
    v->setId(id);
    v->setFixed(id == 0);
    optimizer.addVertex(v);
  }
  g2o::EdgeSE3* e = new g2o::EdgeSE3;
  e->setVertex(0, optimizer.vertex(0));
  e->setVertex(1, optimizer.vertex(1));
  e->setMeasurement(g2o::Isometry3(Eigen::Translation3d(1, 2, 3)));
  optimizer.addEdge(e);

  g2o::EdgeSE3Prior prior;
  prior.setVertex(0, optimizer.vertex(1));
  if (optimizer.addEdge(&prior)) return 1;  // must be refused, because its parameter is missing

  optimizer.initializeOptimization();
  if (optimizer.optimize(10) <= 0) return 2;
  const g2o::VertexSE3* moved = static_cast<g2o::VertexSE3*>(optimizer.vertex(1));
  std::cout << moved->estimate().translation().transpose() << std::endl;
  return std::abs(moved->estimate().translation()[2] - 3) < 1e-6 ? 0 : 3;
}
