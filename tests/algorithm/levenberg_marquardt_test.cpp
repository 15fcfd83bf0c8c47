// SPDX-License-Identifier: BSD-3-Clause
// How the damping of Levenberg-Marquardt changes from step to step.
#include "algorithm/levenberg_marquardt.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <span>
#include <type_traits>

#include "boxplus/optimize/optimizer.h"

namespace boxplus {
namespace {

/// F(x) ≈ F − 2δ + δ² at every x, but a step decreases F by the fraction `gain` of what this predicts. The
/// next `rejects` steps raise F.
class ScriptedSystem final : public System {
 public:
  double gain = 1;
  int rejects = 0;

  double chi2() override { return chi2_; }
  bool linearize() override { return true; }
  std::span<const double> gradient() const override { return gradient_; }
  std::span<const double> diagonal() const override { return diagonal_; }
  double curvature(std::span<const double> d) override { return d[0] * d[0]; }
  StepResult solve(const StepDamping& damping, std::span<double> step) override {
    step[0] = 1 / (1 + damping.lambda);
    return {.exact = true};
  }
  double try_step(std::span<const double> step) override {
    const double this_gain = rejects > 0 ? -1 : gain;
    if (rejects > 0) --rejects;
    return tried_ = chi2_ - this_gain * (2 * step[0] - step[0] * step[0]);
  }
  void accept() override { chi2_ = tried_; }
  void reject() override {}

 private:
  double chi2_ = 1000, tried_ = 0;
  std::array<double, 1> gradient_{-1}, diagonal_{1};
};

/// Runs Levenberg-Marquardt with steps of given gains.
class DampingTest : public ::testing::Test {
 protected:
  DampingTest() { algorithm_.reset({}, 1); }

  /// Takes steps with these gains. `rejected` says whether a step is rejected before each of them. The
  /// damping changes by `factor` after each of them, as the next step shows.
  void expect_factors(std::initializer_list<double> gains, bool rejected, double factor) {
    for (const double gain : gains) {
      step(gain, rejected);
      if (factor_ > 0) {
        EXPECT_NEAR(lambda() / last_, factor_, 1e-9 * factor_) << "before the gain " << gain;
      }
      factor_ = factor;
      last_ = record_.lambda;
    }
  }
  static double by_nielsen(double gain) { return std::max(1.0 / 3, 1 - std::pow(2 * gain - 1, 3)); }

 private:
  /// The damping of the first try.
  double lambda() const { return record_.tries == 1 ? record_.lambda : record_.lambda / 2; }

  void step(double gain, bool rejected) {
    record_ = {};
    system_.gain = gain;
    system_.rejects = rejected ? 1 : 0;
    EXPECT_EQ(algorithm_.iterate(system_, system_.chi2(), record_), IterationOutcome::kAccepted);
    EXPECT_EQ(record_.tries, rejected ? 2 : 1);
  }

  LevenbergMarquardt algorithm_;
  ScriptedSystem system_;
  IterationRecord record_;
  double last_ = 0, factor_ = 0;
};

TEST_F(DampingTest, FollowsTheRuleOfNielsenForPoorAndForVeryGoodSteps) {
  expect_factors({0.45}, false, by_nielsen(0.45));
  expect_factors({0.1}, false, by_nielsen(0.1));
  expect_factors({0.97, 1, 1.2}, false, 1.0 / 3);
  expect_factors({1}, false, 1.0 / 3);
}

TEST_F(DampingTest, IsLoweredToAThirdAfterGoodSteps) {
  expect_factors({0.55, 0.7, 0.8, 0.6, 0.7}, false, 1.0 / 3);
}

TEST_F(DampingTest, IsLoweredToTwoThirdsAtMostAfterARejectedStep) {
  expect_factors({0.7}, true, by_nielsen(0.7));
  expect_factors({1}, true, 2.0 / 3);
  expect_factors({1}, false, 1.0 / 3);
}

TEST_F(DampingTest, IsLoweredMoreSlowlyForTwiceAsLongAfterEachVainAttempt) {
  for (const int wait : {2, 4, 8}) {
    SCOPED_TRACE(wait);
    expect_factors({0.7}, false, 1.0 / 3);
    expect_factors({0.7}, true, by_nielsen(0.7));
    for (int k = 0; k < wait; ++k) expect_factors({0.7}, false, by_nielsen(0.7));
  }
  expect_factors({0.7, 0.7}, false, 1.0 / 3);  // the first of them succeeds
  expect_factors({0.7}, true, by_nielsen(0.7));
  expect_factors({0.7, 0.7}, false, by_nielsen(0.7));
  expect_factors({0.7}, false, 1.0 / 3);
}

TEST(LevenbergMarquardt, FollowsAPointThatIsAlmostAtInfinity) {
  // A step of Gauss-Newton doubles the distance, which decreases chi2 by three quarters of what it predicts.
  Graph graph;
  const auto distance = graph.add_vertex(1.0);
  const auto inverse = [](const auto& d) { return Vector<std::decay_t<decltype(d)>, 1>(1 / d - 1e-4); };
  graph.add_edge(inverse, 1e10, distance);
  const Report report =
      optimize(graph, {.algorithm = AlgorithmKind::kLevenbergMarquardt, .max_iterations = 1000});
  EXPECT_TRUE(report.converged());
  EXPECT_NEAR(graph.estimate(distance), 1e4, 1e-3);
  EXPECT_LE(report.iterations, 25);
}

}  // namespace
}  // namespace boxplus
