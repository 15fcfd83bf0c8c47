// SPDX-License-Identifier: BSD-3-Clause
// Shows that each edge adds blocks to H in the rows and columns of its vertices. The graph has four poses,
// two landmarks, and an edge over three vertices.
#include <cstdio>
#include <initializer_list>
#include <memory>

#include "g2o/core/block_solver.h"
#include "g2o/core/optimization_algorithm_gauss_newton.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/solvers/eigen/linear_solver_eigen.h"
#include "g2o/types/slam2d/types_slam2d.h"

using namespace g2o;

template <class Vertex>
void add_vertex(SparseOptimizer& optimizer, int id, const typename Vertex::EstimateType& estimate) {
  auto* v = new Vertex;
  v->setId(id);
  v->setEstimate(estimate);
  optimizer.addVertex(v);
}

template <class Edge>
Edge* add_edge(SparseOptimizer& optimizer, std::initializer_list<int> ids) {
  auto* e = new Edge;
  size_t i = 0;
  for (const int id : ids) e->setVertex(i++, optimizer.vertex(id));
  e->setInformation(Edge::InformationType::Identity());
  e->setMeasurementFromState();
  optimizer.addEdge(e);
  return e;
}

int main() {
  SparseOptimizer optimizer;
  auto blocks =
      std::make_unique<BlockSolverX>(std::make_unique<LinearSolverEigen<BlockSolverX::PoseMatrixType>>());
  BlockSolverX& solver = *blocks;
  optimizer.setAlgorithm(new OptimizationAlgorithmGaussNewton(std::move(blocks)));
  // [graph]
  for (int id = 0; id < 4; ++id) add_vertex<VertexSE2>(optimizer, id, SE2(id, 0.1 * id, 0.2 * id));
  add_vertex<VertexPointXY>(optimizer, 4, Vector2(1, 2));
  add_vertex<VertexPointXY>(optimizer, 5, Vector2(2, 2));
  optimizer.vertex(0)->setFixed(true);

  add_edge<EdgeSE2>(optimizer, {0, 1});
  add_edge<EdgeSE2>(optimizer, {1, 2});
  add_edge<EdgeSE2>(optimizer, {2, 3});
  add_edge<EdgeSE2PointXY>(optimizer, {1, 4});
  auto* both = add_edge<EdgeSE2TwoPointsXY>(optimizer, {3, 4, 5});
  both->setInformation(Matrix4::Identity() +
                       Matrix4::Constant(0.5));  // the two points have correlated errors
  optimizer.initializeOptimization();
  // [/graph]

  // [blocks]
  optimizer.computeActiveErrors();
  solver.init(&optimizer);
  solver.buildStructure();
  solver.buildSystem();
  const auto n = static_cast<Eigen::Index>(solver.vectorSize());
  MatrixX H = MatrixX::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const VectorX e_i = VectorX::Unit(n, i);
    solver.multiplyHessian(H.col(i).data(), e_i.data());
  }
  // [/blocks]
  std::printf("%d rows; the blocks belong to the vertices", static_cast<int>(n));
  int row = 0, nonzero = 0;
  for (const auto* v : optimizer.indexMapping()) std::printf(" %d", v->id());
  std::printf("\n");
  for (const auto* v : optimizer.indexMapping()) {
    int column = 0;
    for (const auto* w : optimizer.indexMapping()) {
      const bool is_there = !H.block(row, column, v->dimension(), w->dimension()).isZero(1e-12);
      std::printf("%s", is_there ? " #" : " .");
      nonzero += is_there;
      column += w->dimension();
    }
    std::printf("   vertex %d, dimension %d\n", v->id(), v->dimension());
    row += v->dimension();
  }
  return nonzero == 17 && H.isApprox(H.transpose()) ? 0 : 1;
}
