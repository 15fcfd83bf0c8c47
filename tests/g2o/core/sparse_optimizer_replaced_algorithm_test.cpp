// SPDX-License-Identifier: BSD-3-Clause
// An action may replace the algorithm of the optimizer during a run. Meant to run under AddressSanitizer.
#include <gtest/gtest.h>

#include <functional>
#include <utility>

#include "g2o/core/optimization_algorithm_dogleg.h"
#include "g2o/core/small_graph.h"

namespace {

using small_graph::make_solver;

/// An action that calls a function when the action is called for the n-th time.
class OnCall : public g2o::HyperGraphAction {
 public:
  OnCall(int n, std::function<void()> f) : left_(n), f_(std::move(f)) {}
  HyperGraphAction* operator()(const g2o::HyperGraph*, Parameters*) override {
    if (--left_ == 0) f_();
    return this;
  }

 private:
  int left_;
  std::function<void()> f_;
};

class ReplacedAlgorithm : public testing::Test {
 protected:
  void SetUp() override {
    small_graph::add_square(optimizer);
    optimizer.setAlgorithm(new g2o::OptimizationAlgorithmLevenberg(make_solver()));
    ASSERT_TRUE(optimizer.initializeOptimization());
  }
  double chi2() {
    optimizer.computeActiveErrors();
    return optimizer.activeChi2();
  }
  /// The minimum chi2 of the graph that add_square() builds.
  double best_chi2() {
    g2o::SparseOptimizer other;
    small_graph::add_square(other);
    other.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(make_solver()));
    EXPECT_TRUE(other.initializeOptimization());
    EXPECT_EQ(other.optimize(10), 10);
    other.computeActiveErrors();
    return other.activeChi2();
  }
  g2o::SparseOptimizer optimizer;
};

TEST_F(ReplacedAlgorithm, FinishesItsIterationBeforeTheNewAlgorithmStarts) {
  for (int call = 1; call <= 4; ++call) {
    SCOPED_TRACE(call);
    OnCall replace(call,
                   [&] { optimizer.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(make_solver())); });
    ASSERT_TRUE(optimizer.addComputeErrorAction(&replace));
    EXPECT_GT(optimizer.optimize(20), 0);
    ASSERT_TRUE(optimizer.removeComputeErrorAction(&replace));
    EXPECT_NE(dynamic_cast<g2o::OptimizationAlgorithmGaussNewton*>(optimizer.solver()), nullptr);
    EXPECT_NEAR(chi2(), best_chi2(), 1e-12);
    optimizer.clear();
    SetUp();
  }
}

TEST_F(ReplacedAlgorithm, StopsIfThereIsNoNewAlgorithm) {
  OnCall remove(3, [&] { optimizer.setAlgorithm(nullptr); });
  ASSERT_TRUE(optimizer.addComputeErrorAction(&remove));
  const int done = optimizer.optimize(20);
  EXPECT_GT(done, 0);
  EXPECT_LT(done, 20);
  EXPECT_EQ(optimizer.solver(), nullptr);
  EXPECT_EQ(optimizer.optimize(1), -1);
}

TEST_F(ReplacedAlgorithm, MayBeSetAgainDuringTheSameRun) {
  g2o::OptimizationAlgorithm* first = optimizer.solver();
  OnCall swap(2, [&] {
    optimizer.setAlgorithm(new g2o::OptimizationAlgorithmDogleg(make_solver()));
    optimizer.setAlgorithm(first);
  });
  ASSERT_TRUE(optimizer.addPreIterationAction(&swap));
  EXPECT_GT(optimizer.optimize(20), 0);
  EXPECT_EQ(optimizer.solver(), first);
  EXPECT_NEAR(chi2(), best_chi2(), 1e-12);
}

}  // namespace
