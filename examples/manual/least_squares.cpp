// SPDX-License-Identifier: BSD-3-Clause
// Fits the temperature of a cooling cup of tea, T(t) = room + heat · exp(−t / tau), to eight readings of a
// thermometer. room, heat and tau are unknown.
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
#include "g2o/core/optimization_algorithm_levenberg.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/solvers/dense/linear_solver_dense.h"

// [vertex]
/// The unknowns: room (°C), heat (°C) and tau (minutes).
class VertexCup : public g2o::BaseVertex<3, Eigen::Vector3d> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  void setToOriginImpl() override { _estimate << 0, 0, 1; }
  void oplusImpl(const double* update) override { _estimate += Eigen::Vector3d(update); }
  bool read(std::istream& is) override { return is >> _estimate[0] >> _estimate[1] >> _estimate[2] && true; }
  bool write(std::ostream& os) const override { return os << _estimate.transpose() && true; }
};
// [/vertex]

// [edge]
/// A measured temperature (°C) at a given time (minutes).
class EdgeReading : public g2o::BaseUnaryEdge<1, double, VertexCup> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  explicit EdgeReading(double minutes = 0) : _minutes(minutes) {}
  void computeError() override {
    const Eigen::Vector3d& x = static_cast<const VertexCup*>(_vertices[0])->estimate();
    _error[0] = x[0] + x[1] * std::exp(-_minutes / x[2]) - _measurement;
  }
  bool read(std::istream& is) override { return is >> _minutes >> _measurement && readInformationMatrix(is); }
  bool write(std::ostream& os) const override {
    os << _minutes << " " << _measurement << " ";
    return writeInformationMatrix(os);
  }

 private:
  double _minutes;
};
// [/edge]

/// Fits the model from an initial guess with the given algorithm. Returns chi2 after each iteration.
template <class Algorithm>
std::vector<double> fit(const Eigen::Vector3d& guess, int iterations) {
  // [problem]
  using Blocks = g2o::BlockSolverX;
  using Linear = g2o::LinearSolverDense<Blocks::PoseMatrixType>;
  g2o::SparseOptimizer optimizer;
  optimizer.setAlgorithm(new Algorithm(std::make_unique<Blocks>(std::make_unique<Linear>())));

  auto* cup = new VertexCup;
  cup->setId(0);
  cup->setEstimate(guess);
  optimizer.addVertex(cup);

  const double readings[][2] = {{0, 85.2},  {5, 71.4},  {10, 60.9}, {15, 52.3},
                                {20, 46.1}, {30, 36.8}, {40, 30.8}, {60, 25.1}};
  for (const auto& [minutes, temperature] : readings) {
    auto* reading = new EdgeReading(minutes);
    reading->setVertex(0, cup);
    reading->setMeasurement(temperature);
    reading->setInformation(g2o::MatrixN<1>::Constant(1 / (0.3 * 0.3)));  // σ = 0.3 °C
    optimizer.addEdge(reading);
  }
  optimizer.initializeOptimization();
  optimizer.setComputeBatchStatistics(true);
  optimizer.optimize(iterations);
  // [/problem]
  std::vector<double> chi2;
  for (const g2o::G2OBatchStatistics& step : optimizer.batchStatistics()) chi2.push_back(step.chi2);
  const Eigen::Vector3d& x = cup->estimate();
  if (chi2.back() < 16) std::printf("room %.2f °C, heat %.2f °C, tau %.2f minutes; chi2:", x[0], x[1], x[2]);
  return chi2;
}

bool show(const std::vector<double>& chi2) {
  for (const double value : chi2) std::printf(" %.5g", value);
  std::printf("\n");
  return chi2.back() < 16;  // plausible for 8 readings and 3 unknowns
}

int main() {
  using GaussNewton = g2o::OptimizationAlgorithmGaussNewton;
  using Levenberg = g2o::OptimizationAlgorithmLevenberg;
  // [guesses]
  const Eigen::Vector3d good(15, 40, 5), poor(30, 30, 60);
  // [/guesses]
  std::printf("Gauss-Newton from a good guess:\n  ");
  bool ok = show(fit<GaussNewton>(good, 5));
  std::printf("Gauss-Newton from a poor guess:\n  ");
  const bool is_lost = fit<GaussNewton>(poor, 5).back() > 1000;
  std::printf("%s\n", is_lost ? "chi2 stays above 1000" : "");
  std::printf("Levenberg-Marquardt from a poor guess:\n  ");
  ok = show(fit<Levenberg>(poor, 6)) && ok;
  return ok && is_lost ? 0 : 1;
}
