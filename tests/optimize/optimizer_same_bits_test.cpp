// SPDX-License-Identifier: BSD-3-Clause
// The result has the same bits for any number of threads in one process. tests/apps/same_bits.py compares
// several processes.
#include <gtest/gtest.h>

#include <bit>
#include <cstring>

#include "optimize/small_graphs.h"
#include "sanitized.h"

namespace boxplus {
namespace {

struct Outcome {
  Report report;
  std::vector<double> numbers;
};

Outcome run(AlgorithmKind algorithm, LinearSolverKind solver, int threads) {
  Graph graph;
  const auto grid = add_noisy_grid(graph, 9);
  const auto circle = add_noisy_circle(graph, 300);
  for (const EdgeRef& edge : graph.all_edges()) graph.set_kernel(edge, Huber(3.0));
  Outcome outcome;
  outcome.report = optimize(graph, {.algorithm = algorithm,
                                    .linear_solver = solver,
                                    .max_iterations = kSanitized ? 2 : 6,
                                    .threads = threads});
  for (const auto& pose : grid) {
    outcome.numbers.insert(outcome.numbers.end(), graph.estimate(pose).data(),
                           graph.estimate(pose).data() + 7);
  }
  for (const auto& pose : circle) {
    outcome.numbers.insert(outcome.numbers.end(), graph.estimate(pose).data(),
                           graph.estimate(pose).data() + 3);
  }
  return outcome;
}

TEST(SameBits, AreTheResultOfOneTwoAndThreeThreads) {
  for (const auto algorithm : {AlgorithmKind::kDogleg, AlgorithmKind::kLevenbergMarquardt}) {
    for (const auto solver : {LinearSolverKind::kBlockCholesky, LinearSolverKind::kPcg}) {
      const Outcome one = run(algorithm, solver, 1);
      EXPECT_EQ(one.report.workers, 1);
      for (int threads : {2, 3}) {
        const Outcome more = run(algorithm, solver, threads);
        EXPECT_EQ(more.report.workers, threads);
        ASSERT_EQ(one.numbers.size(), more.numbers.size());
        EXPECT_EQ(std::memcmp(one.numbers.data(), more.numbers.data(), one.numbers.size() * sizeof(double)),
                  0);
        EXPECT_EQ(std::bit_cast<std::uint64_t>(one.report.chi2_final),
                  std::bit_cast<std::uint64_t>(more.report.chi2_final));
        EXPECT_EQ(one.report.iterations, more.report.iterations);
      }
    }
  }
}

}  // namespace
}  // namespace boxplus
