// SPDX-License-Identifier: BSD-3-Clause
// A BatchSystem that eliminates vertices while it linearizes computes the same as one that does so later.
#include "optimize/batch_system.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>

#include "linearize/bundle.h"

namespace boxplus {
namespace {

using Scale = Options::DampingScale;

/// All results of one linearization and of one step.
struct Results {
  bool finite = false;
  LinearStatus status = LinearStatus::kOk;
  std::vector<double> gradient, diagonal, step;
  bool operator==(const Results&) const = default;
};

class EarlyElimination : public testing::Test {
 protected:
  explicit EarlyElimination(Bundle b = make_bundle(12, 600, true)) : bundle(std::move(b)) {}

  BatchSystem make_system(int threads) {
    return {bundle.graph,
            {.threads = threads},
            make_linear_solver(LinearSolverKind::kBlockCholesky),
            SchurMode::kAutomatic};
  }
  Results run(BatchSystem& system, const StepDamping& damping, const std::optional<StepDamping>& expected) {
    Results results;
    if (expected) system.expect(*expected);
    results.finite = system.linearize();
    results.gradient.assign(system.gradient().begin(), system.gradient().end());
    results.diagonal.assign(system.diagonal().begin(), system.diagonal().end());
    results.step.resize(results.gradient.size());
    results.status = system.solve(damping, results.step).status;
    return results;
  }

  Bundle bundle;
  Report::Timings timings;
};

TEST_F(EarlyElimination, ComputesTheSameBitsForAnyDampingAndAnyNumberOfThreads) {
  for (const StepDamping& damping : {StepDamping{0, Scale::kDiagonal}, StepDamping{0, Scale::kIdentity},
                                     StepDamping{1e-3, Scale::kDiagonal}, StepDamping{2, Scale::kIdentity}}) {
    BatchSystem late = make_system(1);
    late.configure({}, timings);
    const Results expected = run(late, damping, std::nullopt);
    ASSERT_TRUE(expected.finite);
    ASSERT_EQ(expected.status, LinearStatus::kOk);
    for (const int threads : {1, 2, 3}) {
      BatchSystem early = make_system(threads);
      early.configure({}, timings);
      EXPECT_EQ(run(early, damping, damping), expected) << threads;
      EXPECT_EQ(run(early, damping, damping), expected) << threads;
    }
  }
}

TEST_F(EarlyElimination, DoesNotChangeAStepWithAnotherDamping) {
  const StepDamping damping{1e-3, Scale::kDiagonal}, other{1e-2, Scale::kDiagonal};
  BatchSystem system = make_system(2);
  system.configure({}, timings);
  const Results expected = run(system, damping, std::nullopt), first = run(system, other, other);
  EXPECT_EQ(run(system, damping, other), expected);
  std::vector<double> step(first.step.size());
  EXPECT_EQ(system.solve(other, step).status, LinearStatus::kOk);
  EXPECT_EQ(step, first.step);
}

TEST_F(EarlyElimination, IsNotAffectedByFixedDirectionsOfPoints) {
  for (std::size_t k = 0; k < bundle.points.size(); k += 3)
    bundle.graph.fix_directions(bundle.points[k], {1});
  const StepDamping damping{1e-3, Scale::kDiagonal};
  BatchSystem system = make_system(2);
  system.configure({}, timings);
  EXPECT_EQ(run(system, damping, damping), run(system, damping, std::nullopt));
}

TEST_F(EarlyElimination, ReportsAPointThatIsNotFinite) {
  bundle.graph.set_estimate(bundle.points[70], Vector3(std::numeric_limits<double>::quiet_NaN(), 0, 5));
  BatchSystem system = make_system(2);
  system.configure({}, timings);
  const StepDamping damping{1e-3, Scale::kDiagonal};
  const Results results = run(system, damping, damping);
  EXPECT_FALSE(results.finite);
  EXPECT_EQ(results.status, LinearStatus::kNotFinite);
}

TEST_F(EarlyElimination, CountsTheTimesOfBothPhases) {
  BatchSystem system = make_system(1);
  system.configure({}, timings);
  const StepDamping damping{1e-3, Scale::kDiagonal};
  run(system, damping, damping);
  EXPECT_GT(timings.linearize_s, 0);
  EXPECT_GT(timings.factorize_s, 0);
}

}  // namespace
}  // namespace boxplus
