// SPDX-License-Identifier: BSD-3-Clause
// A BatchSystem that eliminates vertices while it linearizes computes the same as one that does so later.
#include "system/batch_system.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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

/// The parameter says which columns of eliminated vertices are stored.
class EarlyElimination : public testing::TestWithParam<ColumnStorage> {
 protected:
  explicit EarlyElimination(Bundle b = make_bundle(12, 600, true)) : bundle(std::move(b)) {}

  BatchSystem make_system(int threads, ColumnStorage columns = GetParam()) {
    return {bundle.graph,
            {.threads = threads, .columns = columns},
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
  detail::Timings timings;
};

TEST_P(EarlyElimination, ComputesTheSameBitsForAnyDampingAndAnyNumberOfThreads) {
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

TEST_P(EarlyElimination, DoesNotChangeAStepWithAnotherDamping) {
  const StepDamping damping{1e-3, Scale::kDiagonal}, other{1e-2, Scale::kDiagonal};
  BatchSystem system = make_system(2);
  system.configure({}, timings);
  const Results expected = run(system, damping, std::nullopt), first = run(system, other, other);
  EXPECT_EQ(run(system, damping, other), expected);
  std::vector<double> step(first.step.size());
  EXPECT_EQ(system.solve(other, step).status, LinearStatus::kOk);
  EXPECT_EQ(step, first.step);
}

TEST_P(EarlyElimination, ComputesTheStepsAndCurvaturesOfStoredColumns) {
  BatchSystem stored = make_system(1, ColumnStorage::kAll), system = make_system(2);
  stored.configure({}, timings);
  system.configure({}, timings);
  for (const StepDamping& damping : {StepDamping{0, Scale::kDiagonal}, StepDamping{1e-3, Scale::kDiagonal},
                                     StepDamping{2, Scale::kIdentity}}) {
    const Results expected = run(stored, damping, damping), actual = run(system, damping, damping);
    EXPECT_EQ(actual.gradient, expected.gradient);
    EXPECT_EQ(actual.diagonal, expected.diagonal);
    const auto size = static_cast<Eigen::Index>(expected.step.size());
    const Eigen::Map<const Eigen::VectorXd> step(expected.step.data(), size);
    EXPECT_LE((Eigen::Map<const Eigen::VectorXd>(actual.step.data(), size) - step).norm(),
              1e-9 * step.norm());
    const double curvature = stored.curvature(expected.step);
    EXPECT_NEAR(system.curvature(expected.step), curvature, 1e-10 * curvature);
  }
}

TEST_P(EarlyElimination, IsNotAffectedByFixedDirectionsOfPoints) {
  for (std::size_t k = 0; k < bundle.points.size(); k += 3)
    bundle.graph.fix_directions(bundle.points[k], {1});
  const StepDamping damping{1e-3, Scale::kDiagonal};
  BatchSystem system = make_system(2);
  system.configure({}, timings);
  EXPECT_EQ(run(system, damping, damping), run(system, damping, std::nullopt));
}

TEST_P(EarlyElimination, IsNotAffectedByFixedDirectionsOfCameras) {
  for (std::size_t k = 0; k < bundle.cameras.size(); k += 2)
    bundle.graph.fix_directions(bundle.cameras[k], {0, static_cast<int>(1 + k % 5)});
  const StepDamping damping{1e-3, Scale::kDiagonal};
  BatchSystem stored = make_system(1, ColumnStorage::kAll), system = make_system(2);
  ASSERT_EQ(system.plan().columns, GetParam());
  stored.configure({}, timings);
  system.configure({}, timings);
  const Results late = run(system, damping, std::nullopt), expected = run(stored, damping, std::nullopt);
  EXPECT_EQ(run(system, damping, damping), late);
  EXPECT_EQ(late.gradient, expected.gradient);
  EXPECT_EQ(late.diagonal, expected.diagonal);
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < late.step.size(); ++i) {
    difference = std::max(difference, std::abs(late.step[i] - expected.step[i]));
    size = std::max(size, std::abs(expected.step[i]));
  }
  EXPECT_LE(difference, 1e-9 * size);
  for (const std::uint32_t fixed : system.plan().fixed_scalars) EXPECT_EQ(late.step[fixed], 0);
  const std::vector<double> along(late.step.size(), 1e-3);  // also along what is fixed
  const double curvature = stored.curvature(along);
  EXPECT_NEAR(system.curvature(along), curvature, 1e-10 * curvature);
}

TEST_P(EarlyElimination, ReportsAPointThatIsNotFinite) {
  bundle.graph.set_estimate(bundle.points[70], Vector3(std::numeric_limits<double>::quiet_NaN(), 0, 5));
  BatchSystem system = make_system(2);
  system.configure({}, timings);
  const StepDamping damping{1e-3, Scale::kDiagonal};
  const Results results = run(system, damping, damping);
  EXPECT_FALSE(results.finite);
  EXPECT_EQ(results.status, LinearStatus::kNotFinite);
}

TEST_P(EarlyElimination, CountsTheTimesOfBothPhases) {
  BatchSystem system = make_system(1);
  system.configure({}, timings);
  const StepDamping damping{1e-3, Scale::kDiagonal};
  run(system, damping, damping);
  EXPECT_GT(timings.linearize_s, 0);
  EXPECT_GT(timings.factorize_s, 0);
}

INSTANTIATE_TEST_SUITE_P(Columns, EarlyElimination,
                         testing::Values(ColumnStorage::kAll, ColumnStorage::kBatch),
                         [](const auto& columns) {
                           return columns.param == ColumnStorage::kAll ? "stored" : "recomputed";
                         });

}  // namespace
}  // namespace boxplus
