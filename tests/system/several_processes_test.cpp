// SPDX-License-Identifier: BSD-3-Clause
// If processes share a problem, and each has a part of all vectors, an algorithm takes the same steps in each
// of them as for the whole problem. Here, the processes are threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <barrier>
#include <random>
#include <thread>
#include <vector>

#include "boxplus/algorithm/algorithm_table.h"
#include "boxplus/base/function_ref.h"
#include "boxplus/testing/simulate.h"
#include "system/dense_run_system.h"

namespace boxplus {
namespace {

/// The problem that two threads share. The first one computes.
struct SharedProblem {
  explicit SharedProblem(System& shared, std::size_t scalars) : whole(shared), vector(scalars) {}

  System& whole;
  std::vector<double> vector;  ///< the argument or the result of a function, with the parts of both threads
  double number = 0;
  bool flag = false;
  StepResult solved;
  std::array<double, 2> parts{};
  std::barrier<> meeting{2};
};

/// The scalars [first, last) of the problem, as the thread `rank` sees it.
class PartOfSystem final : public System {
 public:
  PartOfSystem(SharedProblem& shared, std::size_t rank, std::size_t first, std::size_t last)
      : shared_(shared), rank_(rank), first_(first), count_(last - first) {}

  double chi2() override {
    together([&] { shared_.number = shared_.whole.chi2(); });
    return shared_.number;
  }
  bool linearize() override {
    together([&] { shared_.flag = shared_.whole.linearize(); });
    return shared_.flag;
  }
  std::span<const double> gradient() const override { return part_of(shared_.whole.gradient()); }
  std::span<const double> diagonal() const override { return part_of(shared_.whole.diagonal()); }
  double curvature(std::span<const double> d) override {
    put(d);
    together([&] { shared_.number = shared_.whole.curvature(shared_.vector); });
    return shared_.number;
  }
  StepResult solve(const StepDamping& damping, std::span<double> step) override {
    together([&] { shared_.solved = shared_.whole.solve(damping, shared_.vector); });
    std::ranges::copy(part_of(shared_.vector), step.begin());
    return shared_.solved;
  }
  double try_step(std::span<const double> step) override {
    put(step);
    together([&] { shared_.number = shared_.whole.try_step(shared_.vector); });
    return shared_.number;
  }
  void accept() override {
    together([&] { shared_.whole.accept(); });
  }
  void reject() override {
    together([&] { shared_.whole.reject(); });
  }
  double sum(double of_entries) const override {
    exchange(of_entries);
    return shared_.parts[0] + shared_.parts[1];
  }
  double max(double of_entries) const override {
    exchange(of_entries);
    return std::max(shared_.parts[0], shared_.parts[1]);
  }
  /// The other thread no longer waits for this one.
  void leave() { shared_.meeting.arrive_and_drop(); }

 private:
  std::span<const double> part_of(std::span<const double> vector) const {
    return vector.subspan(first_, count_);
  }
  void put(std::span<const double> part) {
    meet();  // the last result has been read
    std::ranges::copy(part, shared_.vector.begin() + static_cast<std::ptrdiff_t>(first_));
  }
  void meet() const { shared_.meeting.arrive_and_wait(); }
  void together(detail::FunctionRef<void()> compute) const {
    meet();
    if (rank_ == 0) compute();
    meet();
  }
  void exchange(double of_entries) const {
    meet();
    shared_.parts[rank_] = of_entries;
    meet();
  }

  SharedProblem& shared_;
  std::size_t rank_, first_, count_;
};

/// A graph whose estimates are so far from the optimum that trust regions and damping shorten steps.
Graph world() {
  Graph graph = simulate(World::kManhattan, {.poses = 100, .seed = 3}).graph;
  std::mt19937 random(1);
  std::normal_distribution<> normal(0, 0.4);
  for (const VertexRef& vertex : graph.all_vertices()) {
    const auto pose = graph.typed<SE2>(vertex);
    graph.set_estimate(pose, graph.estimate(pose) * SE2(normal(random), normal(random), normal(random)));
  }
  graph.set_fixed(graph.all_vertices().front(), true);
  return graph;
}

/// Iterates at most `most` times, so that no step is only a rounding error.
std::vector<IterationRecord> run(System& system, const Options& options, std::size_t scalars, int most = 6) {
  std::vector<IterationRecord> records;
  const auto algorithm = make_algorithm(options.algorithm);
  algorithm->reset(options, scalars);
  double chi2 = system.chi2();
  for (int i = 0; i < most; ++i) {
    IterationRecord record;
    const IterationOutcome outcome = algorithm->iterate(system, chi2, record);
    if (outcome != IterationOutcome::kAccepted && outcome != IterationOutcome::kAcceptedShort) break;
    chi2 = record.chi2;
    records.push_back(record);
  }
  return records;
}

struct SeveralProcesses : ::testing::TestWithParam<Options> {};

TEST_P(SeveralProcesses, TakeTheStepsOfASingleOne) {
  const Options& options = GetParam();
  Graph graph = world();
  DenseRunSystem alone(graph);
  const std::size_t scalars = alone.plan().scalars(), middle = scalars / 3;
  const std::vector<IterationRecord> expected = run(alone, options, scalars);
  ASSERT_GT(expected.size(), 3u);

  Graph copy = world();
  DenseRunSystem whole(copy);
  SharedProblem shared(whole, scalars);
  std::array<std::vector<IterationRecord>, 2> records;
  const auto work = [&](std::size_t rank) {
    const std::size_t first = rank == 0 ? 0 : middle, last = rank == 0 ? middle : scalars;
    PartOfSystem part(shared, rank, first, last);
    records[rank] = run(part, options, last - first);
    part.leave();
  };
  std::thread second(work, 1);
  work(0);
  second.join();

  for (const std::vector<IterationRecord>& of_rank : records) {
    ASSERT_EQ(of_rank.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(of_rank[i].chi2, expected[i].chi2, 1e-9 * expected[i].chi2);
      EXPECT_EQ(of_rank[i].chi2, records[0][i].chi2);
      EXPECT_EQ(of_rank[i].tries, expected[i].tries);
      EXPECT_NEAR(of_rank[i].step_max, expected[i].step_max, 1e-6 * expected[i].step_max);
      EXPECT_EQ(of_rank[i].step_max, records[0][i].step_max);
      EXPECT_NEAR(of_rank[i].predicted_decrease, expected[i].predicted_decrease, 1e-6 * expected[i].chi2);
      EXPECT_EQ(of_rank[i].radius, records[0][i].radius);
      EXPECT_EQ(of_rank[i].lambda, records[0][i].lambda);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(ByAlgorithm, SeveralProcesses,
                         ::testing::Values(Options{.algorithm = AlgorithmKind::kGaussNewton},
                                           Options{.algorithm = AlgorithmKind::kDogleg},
                                           Options{.algorithm = AlgorithmKind::kDogleg, .initial_radius = 3},
                                           Options{.algorithm = AlgorithmKind::kLevenbergMarquardt},
                                           Options{.algorithm = AlgorithmKind::kLevenbergMarquardt,
                                                   .damping = Options::DampingScale::kIdentity},
                                           Options{.algorithm = AlgorithmKind::kLevenbergMarquardt,
                                                   .initial_lambda = 10}),
                         [](const auto& one) { return "Options" + std::to_string(one.index); });

}  // namespace
}  // namespace boxplus
