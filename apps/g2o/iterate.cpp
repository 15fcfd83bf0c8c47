// SPDX-License-Identifier: BSD-3-Clause
#include "iterate.h"

#include <csignal>
#include <cstdlib>
#include <limits>

#include "g2o/core/sparse_optimizer_terminate_action.h"

namespace g2o_tool {
namespace {

volatile std::sig_atomic_t interrupts = 0;
bool stop = false;

extern "C" void on_interrupt(int) {
  stop = true;
  interrupts = interrupts + 1;
  if (interrupts == 3) std::_Exit(1);
}

/// Sets the optimizer's stop flag when the gain is small. The base class clears the flag at the start of a
/// run; if an interrupt has been requested before, this action sets the flag again. Near the minimum,
/// rounding errors can make chi2 rise and fall, so that the gain is never small. Therefore this action also
/// stops the run if chi2 has not reached a new minimum in the last kPatience iterations.
class StopOnGain : public g2o::SparseOptimizerTerminateAction {
 public:
  g2o::HyperGraphAction* operator()(const g2o::HyperGraph* graph, Parameters* parameters) override {
    g2o::HyperGraphAction* result = SparseOptimizerTerminateAction::operator()(graph, parameters);
    if (result != nullptr) watch(static_cast<const g2o::SparseOptimizer*>(graph)->activeRobustChi2());
    if (interrupts > 0) stop = true;
    return result;
  }

 private:
  void watch(double chi2) {
    constexpr int kPatience = 20;
    const bool has_fallen = chi2 < best_;
    if (has_fallen) best_ = chi2;
    since_best_ = has_fallen ? 0 : since_best_ + 1;
    if (since_best_ >= kPatience) stop = true;
  }

  double best_ = std::numeric_limits<double>::infinity();
  int since_best_ = 0;
};

int until_gain_is_small(g2o::SparseOptimizer& optimizer, const Options& options) {
  StopOnGain terminate;
  terminate.setGainThreshold(options.gain);
  terminate.setMaxIterations(options.gain_iterations);
  optimizer.addPostIterationAction(&terminate);
  const int iterations = optimizer.optimize(options.gain_iterations);
  optimizer.removePostIterationAction(&terminate);
  stop = interrupts > 0;
  return iterations;
}

}  // namespace

void stop_at_interrupts(g2o::SparseOptimizer& optimizer) {
  optimizer.setForceStopFlag(&stop);
  std::signal(SIGINT, on_interrupt);
}

void iterate(g2o::SparseOptimizer& optimizer, const Options& options, int iterations, Run& run) {
  const int wanted = iterations < 0 ? options.gain_iterations : iterations;
  const int done = iterations < 0 ? until_gain_is_small(optimizer, options) : optimizer.optimize(iterations);
  if (wanted > 0 && done <= 0 && !stop) ++run.failures;
  if (done > 0) run.iterations += done;
  const auto& statistics = optimizer.batchStatistics();
  run.statistics.insert(run.statistics.end(), statistics.begin(), statistics.end());
}

}  // namespace g2o_tool
