// SPDX-License-Identifier: BSD-3-Clause
// Stops Levenberg-Marquardt after three consecutive iterations with small gains, as ORB_SLAM2's copy of g2o
// does.
#include <cmath>
#include <cstdio>
#include <memory>

#include "g2o/core/block_solver.h"
#include "g2o/core/optimization_algorithm_levenberg.h"
#include "g2o/core/robust_kernel_impl.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/solvers/dense/linear_solver_dense.h"
#include "g2o/types/slam2d/types_slam2d.h"

using namespace g2o;

// [action]
/// Stops the optimizer after three consecutive iterations that each lower chi2 by less than 0.1 %.
class EndAfterSmallGains : public HyperGraphAction {
 public:
  explicit EndAfterSmallGains(SparseOptimizer& optimizer) : optimizer_(optimizer) {
    optimizer_.addPostIterationAction(this);
    optimizer_.setForceStopFlag(&stop_);
  }
  ~EndAfterSmallGains() override {
    optimizer_.removePostIterationAction(this);
    optimizer_.setForceStopFlag(nullptr);
  }
  EndAfterSmallGains(const EndAfterSmallGains&) = delete;
  EndAfterSmallGains& operator=(const EndAfterSmallGains&) = delete;

  HyperGraphAction* operator()(const HyperGraph*, Parameters* parameters) override {
    const int iteration = static_cast<ParametersIteration*>(parameters)->iteration;
    if (iteration < 0) {  // called by initializeOptimization()
      optimizer_.computeActiveErrors();
      small_gains_ = 0;
    }
    const double chi2 = optimizer_.activeRobustChi2();
    if (iteration >= 0) small_gains_ = (chi2_before_ - chi2) * 1e3 < chi2_before_ ? small_gains_ + 1 : 0;
    chi2_before_ = chi2;
    stop_ = small_gains_ >= 3;
    return this;
  }

 private:
  SparseOptimizer& optimizer_;
  bool stop_ = false;
  double chi2_before_ = 0;
  int small_gains_ = 0;
};
// [/action]

/// Adds a loop of 30 poses with two odometry measurements per side. Some measurements are wrong.
void add_loop(SparseOptimizer& optimizer) {
  constexpr int kPoses = 30;
  const double turn = 2 * const_pi() / kPoses;
  for (int i = 0; i < kPoses; ++i) {
    auto* pose = new VertexSE2;
    pose->setId(i);
    pose->setFixed(i == 0);
    pose->setEstimate(SE2(std::sin(i), std::cos(3 * i), turn * i));
    optimizer.addVertex(pose);
  }
  for (int i = 0; i < 2 * kPoses; ++i) {
    auto* motion = new EdgeSE2;
    motion->setVertex(0, optimizer.vertex(i % kPoses));
    motion->setVertex(1, optimizer.vertex((i + 1) % kPoses));
    const double wrong = i % 17 == 5 ? 2 : 0;
    motion->setMeasurement(SE2(1 + 0.05 * std::sin(5 * i) + wrong, wrong, turn));
    motion->setInformation(Eigen::Vector3d(100, 100, 1000).asDiagonal());
    motion->setRobustKernel(new RobustKernelHuber);
    optimizer.addEdge(motion);
  }
}

struct Result {
  int iterations;
  double chi2;
};

Result optimized(bool ends_early) {
  SparseOptimizer optimizer;
  optimizer.setAlgorithm(new OptimizationAlgorithmLevenberg(
      std::make_unique<BlockSolverX>(std::make_unique<LinearSolverDense<BlockSolverX::PoseMatrixType>>())));
  add_loop(optimizer);
  int iterations = 0;
  if (ends_early) {
    // [use]
    EndAfterSmallGains end(optimizer);
    optimizer.initializeOptimization();
    iterations = optimizer.optimize(20);
    // [/use]
  } else {
    optimizer.initializeOptimization();
    iterations = optimizer.optimize(20);
  }
  optimizer.computeActiveErrors();
  return {iterations, optimizer.activeRobustChi2()};
}

int main() {
  const Result without = optimized(false), with = optimized(true);
  std::printf("without the action: %d iterations\nwith the action: %d iterations; chi2 is %.2f %% higher\n",
              without.iterations, with.iterations, 100 * (with.chi2 / without.chi2 - 1));
  return with.iterations < without.iterations && with.chi2 < 1.01 * without.chi2 ? 0 : 1;
}
