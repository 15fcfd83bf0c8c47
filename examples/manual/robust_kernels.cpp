// SPDX-License-Identifier: BSD-3-Clause
// Estimates the height of a ceiling from eight echoes. Six echoes come from the ceiling, and two echoes come
// from a lamp that hangs below the ceiling.
#include <cmath>
#include <cstdio>
#include <istream>
#include <memory>
#include <ostream>
#include <vector>

#include "g2o/core/base_unary_edge.h"
#include "g2o/core/base_vertex.h"
#include "g2o/core/block_solver.h"
#include "g2o/core/optimization_algorithm_gauss_newton.h"
#include "g2o/core/robust_kernel_factory.h"
#include "g2o/core/robust_kernel_impl.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/solvers/dense/linear_solver_dense.h"

class VertexHeight : public g2o::BaseVertex<1, double> {
 public:
  void setToOriginImpl() override { _estimate = 0; }
  void oplusImpl(const double* update) override { _estimate += *update; }
  bool read(std::istream& is) override { return is >> _estimate && true; }
  bool write(std::ostream& os) const override { return os << _estimate && true; }
};

class EdgeEcho : public g2o::BaseUnaryEdge<1, double, VertexHeight> {
 public:
  void computeError() override {
    _error[0] = static_cast<const VertexHeight*>(_vertices[0])->estimate() - _measurement;
  }
  void linearizeOplus() override { _jacobianOplusXi(0, 0) = 1; }
  bool read(std::istream& is) override { return is >> _measurement && readInformationMatrix(is); }
  bool write(std::ostream& os) const override {
    os << _measurement << " ";
    return writeInformationMatrix(os);
  }
};

struct Room {
  Room() {
    using Blocks = g2o::BlockSolverX;
    optimizer.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(
        std::make_unique<Blocks>(std::make_unique<g2o::LinearSolverDense<Blocks::PoseMatrixType>>())));
    height = new VertexHeight;
    height->setId(0);
    height->setEstimate(2.3);
    optimizer.addVertex(height);
    for (const double meters : {2.51, 2.49, 2.50, 2.52, 2.48, 2.50, 1.90, 1.88}) {
      auto* echo = new EdgeEcho;
      echo->setVertex(0, height);
      echo->setMeasurement(meters);
      echo->setInformation(g2o::MatrixN<1>::Constant(1 / (0.02 * 0.02)));  // σ = 2 cm
      optimizer.addEdge(echo);
      echoes.push_back(echo);
    }
  }
  g2o::SparseOptimizer optimizer;
  VertexHeight* height;
  std::vector<EdgeEcho*> echoes;
};

double with_kernel(const char* name) {
  Room room;
  // [kernel]
  for (EdgeEcho* echo : room.echoes) {
    echo->setRobustKernel(g2o::RobustKernelFactory::instance()->construct(name));  // nullptr for "none"
    if (echo->robustKernel() != nullptr) echo->robustKernel()->setDelta(2);  // width in standard deviations
  }
  room.optimizer.initializeOptimization();
  room.optimizer.optimize(30);
  // [/kernel]
  std::printf("%-8s %.3f m\n", name, room.height->estimate());
  return room.height->estimate();
}

double in_two_rounds() {
  Room room;
  // [rounds]
  for (EdgeEcho* echo : room.echoes) echo->setRobustKernel(new g2o::RobustKernelHuber);
  room.optimizer.initializeOptimization();
  room.optimizer.optimize(10);
  for (EdgeEcho* echo : room.echoes) {
    echo->setLevel(echo->chi2() > 25 ? 1 : 0);  // errors of more than five standard deviations
    echo->setRobustKernel(nullptr);
  }
  room.optimizer.initializeOptimization(0);  // only the edges of level 0
  room.optimizer.optimize(10);
  // [/rounds]
  std::printf("%-8s %.3f m, from %zu of %zu echoes\n", "rounds", room.height->estimate(),
              room.optimizer.activeEdges().size(), room.echoes.size());
  return room.height->estimate();
}

int main() {
  const double none = with_kernel("none"), huber = with_kernel("Huber"), cauchy = with_kernel("Cauchy");
  const double rounds = in_two_rounds();
  const bool is_better = std::abs(huber - 2.5) < std::abs(none - 2.5) && std::abs(cauchy - 2.5) < 0.01;
  return is_better && std::abs(rounds - 2.5) < 0.001 ? 0 : 1;
}
