// SPDX-License-Identifier: BSD-3-Clause
// Estimates two positions on a line from one measurement: the second position is 1 larger than the first
// position. The gauge is free unless a position is fixed or has a prior.
#include <cmath>
#include <cstdio>
#include <istream>
#include <memory>
#include <ostream>

#include "g2o/core/base_binary_edge.h"
#include "g2o/core/base_unary_edge.h"
#include "g2o/core/base_vertex.h"
#include "g2o/core/block_solver.h"
#include "g2o/core/optimization_algorithm_gauss_newton.h"
#include "g2o/core/optimization_algorithm_levenberg.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/solvers/dense/linear_solver_dense.h"

// [types]
class VertexPlace : public g2o::BaseVertex<1, double> {
 public:
  void setToOriginImpl() override { _estimate = 0; }
  void oplusImpl(const double* update) override { _estimate += *update; }
  bool read(std::istream& is) override { return is >> _estimate && true; }
  bool write(std::ostream& os) const override { return os << _estimate && true; }
};

/// e = z − (x₂ − x₁)
class EdgeDistance : public g2o::BaseBinaryEdge<1, double, VertexPlace, VertexPlace> {
 public:
  void computeError() override {
    const double x1 = static_cast<const VertexPlace*>(_vertices[0])->estimate();
    const double x2 = static_cast<const VertexPlace*>(_vertices[1])->estimate();
    _error[0] = _measurement - (x2 - x1);
  }
  void linearizeOplus() override {
    _jacobianOplusXi(0, 0) = 1;
    _jacobianOplusXj(0, 0) = -1;
  }
  bool read(std::istream& is) override { return is >> _measurement && readInformationMatrix(is); }
  bool write(std::ostream& os) const override {
    os << _measurement << " ";
    return writeInformationMatrix(os);
  }
};
// [/types]

/// A prior on one position.
class EdgePrior : public g2o::BaseUnaryEdge<1, double, VertexPlace> {
 public:
  void computeError() override {
    _error[0] = static_cast<const VertexPlace*>(_vertices[0])->estimate() - _measurement;
  }
  void linearizeOplus() override { _jacobianOplusXi(0, 0) = 1; }
  bool read(std::istream& is) override { return is >> _measurement && readInformationMatrix(is); }
  bool write(std::ostream& os) const override {
    os << _measurement << " ";
    return writeInformationMatrix(os);
  }
};

using Blocks = g2o::BlockSolverX;

std::unique_ptr<Blocks> make_blocks() {
  return std::make_unique<Blocks>(std::make_unique<g2o::LinearSolverDense<Blocks::PoseMatrixType>>());
}

struct Line {
  explicit Line(g2o::OptimizationAlgorithm* algorithm) {
    optimizer.setAlgorithm(algorithm);
    for (const int id : {1, 2}) {
      auto* v = new VertexPlace;
      v->setId(id);
      v->setToOrigin();
      optimizer.addVertex(v);
    }
    auto* e = new EdgeDistance;
    e->setVertex(0, optimizer.vertex(1));
    e->setVertex(1, optimizer.vertex(2));
    e->setMeasurement(1);
    e->setInformation(g2o::MatrixN<1>::Constant(2));
    optimizer.addEdge(e);
  }
  double place(int id) const { return static_cast<const VertexPlace*>(optimizer.vertex(id))->estimate(); }
  bool report(const char* how) {
    optimizer.initializeOptimization();
    const int iterations = optimizer.optimize(10);
    std::printf("%-28s x = (%.3f, %.3f) %s\n", how, place(1), place(2), iterations > 0 ? "" : "failed");
    return iterations > 0 && std::abs(place(2) - place(1) - 1) < 1e-6;
  }
  g2o::SparseOptimizer optimizer;
};

/// Prints the linear system that the solver builds in the first iteration.
bool print_system() {
  // [system]
  auto blocks = make_blocks();
  Blocks& solver = *blocks;
  Line line(new g2o::OptimizationAlgorithmGaussNewton(std::move(blocks)));
  line.optimizer.initializeOptimization();
  line.optimizer.computeActiveErrors();
  solver.init(&line.optimizer);
  solver.buildStructure();
  solver.buildSystem();
  Eigen::Matrix2d H = Eigen::Matrix2d::Zero();
  for (const int i : {0, 1}) solver.multiplyHessian(H.col(i).data(), Eigen::Vector2d::Unit(i).eval().data());
  // [/system]
  std::printf("H = (%g %g; %g %g), det H = %g, b = (%g %g)\n", H(0, 0), H(0, 1), H(1, 0), H(1, 1),
              H.determinant(), solver.b()[0], solver.b()[1]);
  return H.determinant() == 0 && solver.b()[0] == -2 && solver.b()[1] == 2;
}

int main() {
  using GaussNewton = g2o::OptimizationAlgorithmGaussNewton;
  bool ok = print_system();

  Line floating(new GaussNewton(make_blocks()));
  std::printf("gauge freedom: %s\n", floating.optimizer.gaugeFreedom() ? "yes" : "no");
  ok = !floating.report("Gauss-Newton, nothing fixed:") && ok;

  // [fixed]
  Line fixed(new GaussNewton(make_blocks()));
  fixed.optimizer.findGauge()->setFixed(true);
  // [/fixed]
  ok = fixed.report("Gauss-Newton, x1 fixed:") && ok;

  // [prior]
  Line held(new GaussNewton(make_blocks()));
  auto* prior = new EdgePrior;
  prior->setVertex(0, held.optimizer.vertex(1));
  prior->setMeasurement(0);
  prior->setInformation(g2o::MatrixN<1>::Constant(1));
  held.optimizer.addEdge(prior);
  // [/prior]
  ok = held.report("Gauss-Newton, prior on x1:") && ok;

  // [damped]
  Line damped(new g2o::OptimizationAlgorithmLevenberg(make_blocks()));
  // [/damped]
  return damped.report("Levenberg, nothing fixed:") && ok ? 0 : 1;
}
