// SPDX-License-Identifier: BSD-3-Clause
// A system of bundle adjustment that is so large that boxplus does not store the columns of its points.
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "boxplus/testing/simulate_bundle.h"
#include "system/batch_system.h"

namespace boxplus {

/// No vertex is fixed, so the gauge is free.
inline const Graph& large_bundle() {
  static const BundleSimulation simulation =
      simulate_bundle(BundleShape::kRing, {.cameras = 12, .points = 3600});
  return simulation.graph;
}

/// The parameters are the columns that are stored, and the number of threads.
class BundleSystem : public ::testing::TestWithParam<std::tuple<ColumnStorage, int>> {
 protected:
  static constexpr StepDamping kUndamped{}, kDamped{1e-3, Options::DampingScale::kDiagonal},
      kByIdentity{2, Options::DampingScale::kIdentity};

  static ColumnStorage columns() { return std::get<0>(GetParam()); }
  static int threads() { return std::get<1>(GetParam()); }
  static BatchSystem make_system(
      Graph& graph, ColumnStorage columns, int threads,
      std::shared_ptr<LinearSolver> solver = make_linear_solver(LinearSolverKind::kBlockCholesky)) {
    return {graph, {.threads = threads, .columns = columns}, std::move(solver), SchurMode::kAutomatic};
  }
  static std::vector<double> copy(std::span<const double> vector) { return {vector.begin(), vector.end()}; }

  BundleSystem() { system_.configure({}, timings_, StopToken(&stop_)); }

  std::vector<double> zeros() const { return std::vector<double>(system_.plan().scalars()); }
  std::vector<double> solve(const StepDamping& damping) {
    std::vector<double> step = zeros();
    EXPECT_EQ(system_.solve(damping, step).status, LinearStatus::kOk);
    return step;
  }
  /// A step from `seed` that is not a solution. Its entries are at most `largest`.
  std::vector<double> any_step(double largest = 1e-3, unsigned seed = 1) const {
    std::mt19937 random(seed);
    std::vector<double> step = zeros();
    for (double& entry : step) entry = largest * (2.0 * random() / std::mt19937::max() - 1);
    return step;
  }

  Graph graph_ = large_bundle();
  std::atomic<bool> stop_ = false;
  detail::Timings timings_;
  BatchSystem system_ = make_system(graph_, columns(), threads());
};

inline std::string name_of_storage(
    const ::testing::TestParamInfo<std::tuple<ColumnStorage, int>>& parameters) {
  const auto [columns, threads] = parameters.param;
  return (columns == ColumnStorage::kAll ? "stored" : "recomputed") + std::to_string(threads);
}

inline auto every_storage() {
  return ::testing::Combine(::testing::Values(ColumnStorage::kAll, ColumnStorage::kBatch),
                            ::testing::Values(1, 3));
}

}  // namespace boxplus
