// SPDX-License-Identifier: BSD-3-Clause
// Every phase of optimize() obeys Options::time_limit_s. These tests replace the clock by a fake.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <functional>
#include <string>
#include <tuple>
#include <vector>

#include "boxplus/testing/simulate.h"
#include "fake_clock.h"
#include "guess/initial_guess.h"
#include "linear/block_cholesky/symbolic_factor.h"
#include "linear/ordering/amd_ordering.h"
#include "linear/ordering/nested_dissection.h"
#include "linearize/linearizer.h"
#include "optimize/small_graphs.h"
#include "optimize/table_entries.h"

namespace boxplus {
namespace {

using ::testing::HasSubstr;

constexpr double kHour = 3600;

std::vector<std::vector<double>> estimates(const Graph& graph) {
  std::vector<std::vector<double>> all;
  for (const VertexRef& vertex : graph.all_vertices()) {
    const auto data = graph.estimate(graph.typed<SE2>(vertex)).vector();
    all.emplace_back(data.data(), data.data() + 3);
  }
  return all;
}

Graph noisy_circle() {
  Graph graph;
  const auto poses = add_noisy_circle(graph, 150);
  for (std::size_t k = 0; k + 50 < poses.size(); k += 3) {
    graph.add_edge(Between(graph.estimate(poses[k]).inverse_times(graph.estimate(poses[k + 50]))), poses[k],
                   poses[k + 50]);
  }
  return graph;
}

/// Checks that the report of a run that the time limit ended agrees with the estimates in the graph.
void expect_correct_report(const Report& report, const Graph& graph,
                           const std::vector<std::vector<double>>& before) {
  ASSERT_EQ(report.status, Report::Status::kNotConverged) << report;
  ASSERT_EQ(report.reason, Report::Reason::kTimeLimit) << report;
  if (std::isnan(report.chi2_initial)) {
    EXPECT_TRUE(std::isnan(report.chi2_final));
    EXPECT_EQ(report.iterations, 0);
    EXPECT_THAT(report.message, HasSubstr("before chi2 was evaluated"));
  } else {
    EXPECT_LE(report.chi2_final, report.chi2_initial);
    EXPECT_NEAR(report.chi2_final, graph.chi2(), 1e-12 * graph.chi2());
  }
  if (report.iterations == 0 && report.start.used == Start::kCurrent) {
    EXPECT_EQ(estimates(graph), before);
  }
}

class EveryStart : public ::testing::TestWithParam<std::tuple<Start, AlgorithmKind>> {
 protected:
  void TearDown() override { testing::stop_clock(); }
};

TEST_P(EveryStart, StopsAtAnyReadingOfTheClockWithACorrectReport) {
  Options options{.algorithm = std::get<1>(GetParam()), .start = std::get<0>(GetParam()), .threads = 1};
  options.time_limit_s = kHour / 2;
  Graph whole = noisy_circle();
  const long begin = testing::clock_readings();
  const Report reference = optimize(whole, options);
  const long readings = testing::clock_readings() - begin;
  ASSERT_TRUE(reference.converged()) << reference;
  bool after_one_step = false, after_more_steps = false;
  // A stopwatch of optimize() makes the first reading, so the loop begins with the second one.
  for (long k = 2; k < readings; k += 1 + readings / 60) {
    SCOPED_TRACE("reading " + std::to_string(k));
    Graph graph = noisy_circle();
    const auto before = estimates(graph);
    testing::jump_at_reading(k);
    const long first = testing::clock_readings();
    const Report report = optimize(graph, options);
    // After the jump, the clock is read a few more times: by stopwatches that end, and by each function that
    // checks the time limit before it returns.
    constexpr long kReadingsAfterTheJump = 30;
    EXPECT_LE(testing::clock_readings() - first, k + kReadingsAfterTheJump);
    testing::stop_clock();
    if (report.converged()) continue;  // the run ended before a function checked the limit again
    expect_correct_report(report, graph, before);
    after_one_step |= report.iterations == 1;
    after_more_steps |= report.iterations > 1;
    const Report later = optimize(graph, options);
    EXPECT_TRUE(later.converged()) << later;
    EXPECT_NEAR(later.chi2_final, reference.chi2_final, 1e-6 * reference.chi2_final);
  }
  EXPECT_TRUE(after_one_step);
  EXPECT_TRUE(after_more_steps);
}

INSTANTIATE_TEST_SUITE_P(TimeLimit, EveryStart,
                         ::testing::Combine(::testing::ValuesIn(every_start()),
                                            ::testing::ValuesIn(every_algorithm())),
                         [](const auto& test) {
                           return test_name(std::get<0>(test.param)) + "_" +
                                  test_name(std::get<1>(test.param));
                         });

/// The first reading of the clock belongs to the Stopwatch of the run, so the time is over from the second
/// on.
TEST(TimeLimit, ThatIsShorterThanAnIterationEndsARunAfterItsFirstStep) {
  Graph graph = noisy_circle(), whole = noisy_circle();
  const double best = optimize(whole).chi2_final;
  Optimizer optimizer(graph, {.max_iterations = 5, .time_limit_s = 1e-3, .threads = 1});
  double chi2 = graph.chi2();
  for (int run = 0; run < 30 && chi2 > (1 + 1e-6) * best; ++run) {
    testing::jump_at_reading(2);
    const Report report = optimizer.run();
    testing::stop_clock();
    EXPECT_EQ(report.reason, Report::Reason::kTimeLimit) << report;
    EXPECT_EQ(report.iterations, 1);
    EXPECT_LT(report.chi2_final, chi2);
    chi2 = report.chi2_final;
  }
  EXPECT_NEAR(chi2, best, 1e-6 * best);
}

TEST(TimeLimit, DoesNotDelayTheStopFlag) {
  Graph graph = noisy_circle();
  const auto before = estimates(graph);
  const std::atomic<bool> stop = true;
  EXPECT_EQ(optimize(graph, {.time_limit_s = 1e-3, .stop = &stop}).reason, Report::Reason::kStopFlag);
  EXPECT_EQ(estimates(graph), before);
}

TEST(TimeLimit, OfZeroStopsBeforeAnyWork) {
  Graph graph = noisy_circle();
  const auto before = estimates(graph);
  const Report report = optimize(graph, {.time_limit_s = 0});
  expect_correct_report(report, graph, before);
  EXPECT_TRUE(std::isnan(report.chi2_initial));
  EXPECT_THAT(to_string(report), HasSubstr("time limit"));
}

/// A function that runs a phase with a stop token, on a problem of about the given number of poses.
using Phase = std::function<void(int, const StopToken&)>;

BlockStructure structure_of(int poses) {
  const Simulation world = simulate(World::kGrid, {.poses = poses});
  return make_plan(world.graph, {}).structure;
}

template <class F>
Phase on_structure(F&& f) {
  return [f](int poses, const StopToken& stop) { f(structure_of(poses), stop); };
}

template <class F>
Phase on_graph(F&& f) {
  return [f](int poses, const StopToken& stop) {
    Simulation world = simulate(World::kGrid, {.poses = poses});
    const Plan plan = make_plan(world.graph, {});
    f(world.graph, plan, stop);
  };
}

std::vector<std::pair<std::string, Phase>> phases() {
  std::vector<std::pair<std::string, Phase>> all{
      {"plan", on_graph([](Graph& g, const Plan&, const StopToken& stop) { make_plan(g, {.stop = stop}); })},
      {"block structure", on_structure([](const BlockStructure& s, const StopToken& stop) {
         std::vector<BlockCoordinate> lower;
         for (std::uint32_t j = 0; j + 1 < s.blocks(); ++j) lower.push_back({j + 1, j});
         make_block_structure(std::vector<std::uint32_t>(s.blocks(), 3), lower, stop);
       })},
      {"AMD ordering",
       on_structure([](const BlockStructure& s, const StopToken& stop) { amd_ordering(s, {}, stop); })},
      {"nested dissection", on_structure([](const BlockStructure& s, const StopToken& stop) {
         nested_dissection(s, {}, 1, stop);
       })},
      {"supernodes", on_structure([](const BlockStructure& s, const StopToken& stop) {
         const auto order = amd_ordering(s);
         outline_factor(s, {}, {}, Ordering::kMinimumDegree, 1, order, stop);
       })},
      {"indices of the factor", on_structure([](const BlockStructure& s, const StopToken& stop) {
         complete_factor(s, outline_factor(s, {}), {}, 1, stop);
       })},
      {"linearization", on_graph([](Graph& g, const Plan& plan, const StopToken& stop) {
         Linearizer linearizer(g, plan);
         linearizer.set_stop(stop);
         linearizer.linearize({});
       })},
      {"chi2", on_graph([](Graph& g, const Plan& plan, const StopToken& stop) {
         Linearizer linearizer(g, plan);
         linearizer.set_stop(stop);
         linearizer.chi2();
       })}};
  for (const detail::StartEntry& start : every_guess()) {
    all.emplace_back(to_string(start.start),
                     on_graph([guess = start.guess](Graph& g, const Plan& plan, const StopToken& stop) {
                       EXPECT_TRUE(guess(g, plan, {.stop = stop}).made);
                     }));
  }
  return all;
}

/// If a larger problem reads the clock more often, the work between two readings does not grow.
TEST(TimeLimit, IsCheckedMoreOftenInEachPhaseIfTheProblemIsLarger) {
  for (const auto& [name, phase] : phases()) {
    SCOPED_TRACE(name);
    const auto readings = [run = phase](int poses) {
      const StopToken stop(nullptr, StopToken::Clock::now(), kHour);
      const long before = testing::clock_readings();
      run(poses, stop);
      return testing::clock_readings() - before;
    };
    const long small = readings(2197), large = readings(4 * 2197);
    EXPECT_GE(small, 2);
    EXPECT_GE(large, 3 * small);
  }
}

TEST(TimeLimit, PreventsAnOrderingThatIsPredictedToExceedIt) {
  const BlockStructure structure = structure_of(8000);
  EXPECT_THROW(amd_ordering(structure, {}, StopToken(nullptr, StopToken::Clock::now(), 1e-4)), Stopped);
  EXPECT_EQ(amd_ordering(structure, {}, StopToken(nullptr, StopToken::Clock::now(), kHour)).size(),
            structure.blocks());
}

}  // namespace
}  // namespace boxplus
