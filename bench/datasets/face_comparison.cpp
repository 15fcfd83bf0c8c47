// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/face_comparison.h"

#include <cmath>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "boxplus/base/parallel.h"
#include "boxplus/optimize/optimizer.h"
#include "datasets/datasets.h"
#include "datasets/interleave.h"
#include "datasets/median.h"
#include "g2o/core/block_solver.h"
#include "g2o/core/factory.h"
#include "g2o/core/optimization_algorithm_gauss_newton.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/solvers/eigen/linear_solver_eigen.h"

G2O_USE_TYPE_GROUP(slam2d)
G2O_USE_TYPE_GROUP(slam3d)

namespace boxplus::bench {
namespace {

constexpr int kIterations = 6;

Figures run_native(Graph& graph) {
  graph.push();
  const Report report = optimize(graph, {.algorithm = AlgorithmKind::kGaussNewton,
                                         .max_iterations = kIterations,
                                         .cost_tolerance = 0,
                                         .step_tolerance = 0,
                                         .threads = detail::hardware_threads()});
  graph.pop();
  std::vector<double> seconds;
  for (std::size_t i = 1; i < report.records.size(); ++i)
    seconds.push_back(report.records[i].time_s - report.records[i - 1].time_s);
  return {report.time.linearize_s / report.iterations, median(seconds), report.chi2_final};
}

Figures run_face(g2o::SparseOptimizer& optimizer) {
  optimizer.push();
  optimizer.optimize(kIterations);
  std::vector<double> linearize, iteration;
  for (const g2o::G2OBatchStatistics& s : optimizer.batchStatistics()) {
    linearize.push_back(s.timeQuadraticForm);
    if (s.iteration > 0) iteration.push_back(s.timeIteration);
  }
  optimizer.computeActiveErrors();
  const double chi2 = optimizer.activeChi2();
  optimizer.pop();
  return {median(linearize), median(iteration), chi2};
}

/// Reads a graph and moves its estimates near the minimum, by one iteration from the chordal guess. From the
/// estimates in the file torus3D, Gauss-Newton diverges, so the final chi2 of the two APIs would not be
/// equal.
GraphFile read_near_minimum(const std::string& path) {
  GraphFile file = read_anchored(path);
  std::ignore = optimize(file.graph, {.start = Start::kChordal, .max_iterations = 1});
  return file;
}

void prepare(g2o::SparseOptimizer& optimizer, const GraphFile& file) {
  using Blocks = g2o::BlockSolverX;
  using Linear = g2o::LinearSolverEigen<Blocks::PoseMatrixType>;
  std::istringstream text(format_graph(file));
  if (!optimizer.load(text))
    throw std::runtime_error("the g2o API cannot read the graph that the native API wrote");
  optimizer.setAlgorithm(std::make_unique<g2o::OptimizationAlgorithmGaussNewton>(
      std::make_unique<Blocks>(std::make_unique<Linear>())));
  optimizer.setComputeBatchStatistics(true);
  optimizer.initializeOptimization();
}

}  // namespace

FaceComparison run_face_comparison(const std::string& path) {
  GraphFile file = read_near_minimum(path);
  g2o::SparseOptimizer optimizer;
  prepare(optimizer, file);
  const std::vector<Figures> medians =
      interleaved_medians({[&] { return run_native(file.graph); }, [&] { return run_face(optimizer); }});
  const double native = medians[0][2], face = medians[1][2];
  if (!(std::abs(native - face) <= 1e-9 * native))
    throw std::runtime_error("the two APIs end at different chi2");
  return {{medians[0][0], medians[0][1]}, {medians[1][0], medians[1][1]}};
}

}  // namespace boxplus::bench
