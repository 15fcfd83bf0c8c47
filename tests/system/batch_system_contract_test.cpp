// SPDX-License-Identifier: BSD-3-Clause
// The contract of boxplus/system/system.h holds for every storage of columns.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/vector_math.h"
#include "boxplus/algorithm/algorithm.h"
#include "boxplus/optimize/optimizer.h"
#include "system/bundle_system.h"

namespace boxplus {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class SystemContract : public BundleSystem {
 protected:
  static std::vector<double> sum(std::span<const double> a, double factor, std::span<const double> b) {
    std::vector<double> result(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) result[i] = a[i] + factor * b[i];
    return result;
  }
  /// aᵀHb.
  double product(std::span<const double> a, std::span<const double> b) {
    return (system_.curvature(sum(a, 1, b)) - system_.curvature(sum(a, -1, b))) / 4;
  }
  /// Expects that a call is refused, and that its message contains `expected`.
  template <class F>
  void expect_refusal(F&& call, const char* expected) {
    EXPECT_THAT(call, ThrowsMessage<InvalidArgument>(HasSubstr(expected)));
  }
  /// Expects that all functions that need a linearization are refused.
  void expect_that_linearization_is_missing() {
    std::vector<double> step = any_step();
    expect_refusal([&] { (void)system_.solve(kDamped, step); }, "System::solve: expected linearize()");
    expect_refusal([&] { system_.curvature(step); }, "System::curvature: expected linearize()");
    expect_refusal([&] { system_.try_step(step); }, "System::try_step: expected linearize()");
    EXPECT_EQ(step, any_step());
  }
};

TEST(AutomaticColumns, AreNotStoredForTheBundleOfTheseTests) {
  Graph graph = large_bundle();
  const BatchSystem system(graph, {.columns = ColumnStorage::kAutomatic},
                           make_linear_solver(LinearSolverKind::kBlockCholesky), SchurMode::kAutomatic);
  EXPECT_EQ(system.plan().columns, ColumnStorage::kBatch);
  EXPECT_GE(system.plan().chunks.size(), 3u);
}

TEST_P(SystemContract, ModelsTheCostToSecondOrder) {
  const double chi2 = system_.chi2();
  ASSERT_TRUE(system_.linearize());
  const std::vector<double> step = solve(kDamped);
  const double slope = 2 * dot(system_.gradient(), step), bend = system_.curvature(step);
  EXPECT_EQ(system_.diagonal().size(), step.size());
  double last = 0;
  for (const double length : {1e-3, 1e-4}) {
    const double actual = system_.try_step(sum(zeros(), length, step)) - chi2;
    system_.reject();
    const double error = std::abs(actual - (length * slope + length * length * bend));
    EXPECT_LT(error, 0.1 * length * length * bend);
    if (last > 0) {
      EXPECT_LT(error, last / 50) << "the error shrinks with the square of the length";
    }
    last = error;
  }
}

TEST_P(SystemContract, ReturnsTheDiagonalOfH) {
  ASSERT_TRUE(system_.linearize());
  const std::size_t scalars = system_.gradient().size();
  for (const std::size_t i : {std::size_t{0}, std::size_t{1001}, scalars - 3, scalars - 200}) {
    std::vector<double> unit = zeros();
    unit[i] = 1;
    EXPECT_NEAR(system_.curvature(unit), system_.diagonal()[i], 1e-12 * system_.diagonal()[i]);
  }
}

TEST_P(SystemContract, SolvesTheDampedSystem) {
  ASSERT_TRUE(system_.linearize());
  for (const StepDamping& damping : {kDamped, kByIdentity}) {
    const std::vector<double> step = solve(damping), direction = any_step(1);
    double damped = 0, size = 0;
    for (std::size_t i = 0; i < step.size(); ++i) {
      const double scale = damping.scale == Options::DampingScale::kIdentity ? 1 : system_.diagonal()[i];
      damped += damping.lambda * scale * step[i] * direction[i];
      size += std::abs(system_.gradient()[i] * direction[i]);
    }
    EXPECT_NEAR(product(direction, step) + damped, -dot(system_.gradient(), direction), 1e-9 * size);
  }
}

TEST_P(SystemContract, SatisfiesTheSystemAlongAStepThatIsExact) {
  ASSERT_TRUE(system_.linearize());
  std::vector<double> step = zeros();
  const StepResult solved = system_.solve(kByIdentity, step);
  ASSERT_TRUE(solved.exact);
  const double slope = -dot(system_.gradient(), step);
  EXPECT_NEAR(system_.curvature(step) + kByIdentity.lambda * dot(step, step), slope, 1e-10 * slope);
}

TEST_P(SystemContract, ComputesTheSameBitsInEveryOrderOfItsCalls) {
  const double chi2 = system_.chi2();
  ASSERT_TRUE(system_.linearize());
  const std::vector<StepDamping> dampings{kDamped, kUndamped, kByIdentity};
  std::vector<std::vector<double>> steps;
  std::vector<double> curvatures;
  for (const StepDamping& damping : dampings) {
    steps.push_back(solve(damping));
    curvatures.push_back(system_.curvature(steps.back()));
  }
  for (const std::size_t k : {1u, 1u, 0u, 2u, 0u, 1u, 2u, 2u}) {
    const double moved = system_.try_step(k == 2 ? any_step(0.1) : steps[k]);
    EXPECT_NE(moved, chi2);
    EXPECT_EQ(system_.chi2(), moved);
    system_.reject();
    EXPECT_EQ(solve(dampings[k]), steps[k]);
    EXPECT_EQ(system_.curvature(steps[k]), curvatures[k]);
    EXPECT_EQ(system_.chi2(), chi2);
  }
}

TEST_P(SystemContract, ComputesTheSameAsOneThreadThatStoresAllColumns) {
  Graph other = graph_;
  detail::Timings other_timings;
  BatchSystem same_columns = make_system(other, columns(), 1),
              all_columns = make_system(other, ColumnStorage::kAll, 1);
  ASSERT_TRUE(system_.linearize());
  for (BatchSystem* reference : {&same_columns, &all_columns}) {
    reference->configure({}, other_timings);
    ASSERT_TRUE(reference->linearize());
    EXPECT_EQ(copy(system_.gradient()), copy(reference->gradient()));
    EXPECT_EQ(copy(system_.diagonal()), copy(reference->diagonal()));
  }
  for (const StepDamping& damping : {kDamped, kUndamped, kByIdentity}) {
    const std::vector<double> step = solve(damping);
    std::vector<double> same = zeros(), expected = zeros();
    (void)same_columns.solve(damping, same);
    (void)all_columns.solve(damping, expected);
    EXPECT_EQ(step, same);
    EXPECT_EQ(system_.curvature(step), same_columns.curvature(step));
    const std::vector<double> difference = sum(step, -1, expected);
    EXPECT_LE(dot(difference, difference), 1e-16 * dot(expected, expected));
  }
}

TEST_P(SystemContract, DemandsALinearizationBeforeAStep) {
  const double chi2 = system_.chi2();
  expect_that_linearization_is_missing();
  ASSERT_TRUE(system_.linearize());
  system_.try_step(solve(kDamped));
  system_.accept();
  const double accepted = system_.chi2();
  EXPECT_LT(accepted, chi2);
  expect_that_linearization_is_missing();
  EXPECT_EQ(system_.chi2(), accepted) << "a refused call changes nothing";
  system_.configure({}, timings_);
  expect_that_linearization_is_missing();
}

TEST_P(SystemContract, LinearizesAgainAfterAccept) {
  ASSERT_TRUE(system_.linearize());
  system_.try_step(solve(kDamped));
  system_.accept();
  ASSERT_TRUE(system_.linearize());
  Graph moved = graph_;
  detail::Timings fresh_timings;
  BatchSystem fresh = make_system(moved, columns(), threads());
  fresh.configure({}, fresh_timings);
  ASSERT_TRUE(fresh.linearize());
  std::vector<double> expected = zeros();
  ASSERT_EQ(fresh.solve(kDamped, expected).status, LinearStatus::kOk);
  EXPECT_EQ(copy(system_.gradient()), copy(fresh.gradient()));
  EXPECT_EQ(solve(kDamped), expected);
  EXPECT_EQ(system_.curvature(expected), fresh.curvature(expected));
}

TEST_P(SystemContract, DemandsThatATriedStepIsAcceptedOrRejected) {
  const char* const expected = "expected accept() or reject() after try_step()";
  ASSERT_TRUE(system_.linearize());
  const std::vector<double> step = solve(kDamped);
  const double moved = system_.try_step(step);
  std::vector<double> other = step;
  expect_refusal([&] { system_.linearize(); }, expected);
  expect_refusal([&] { (void)system_.solve(kDamped, other); }, expected);
  expect_refusal([&] { system_.curvature(step); }, expected);
  expect_refusal([&] { system_.try_step(step); }, expected);
  EXPECT_EQ(system_.chi2(), moved);
  system_.reject();
  EXPECT_EQ(solve(kDamped), step);
}

TEST_P(SystemContract, AcceptsAndRejectsOnlyTriedSteps) {
  const char* const expected = "expected an earlier try_step()";
  const auto expect_no_trial = [&] {
    expect_refusal([&] { system_.accept(); }, expected);
    expect_refusal([&] { system_.reject(); }, expected);
  };
  const double chi2 = system_.chi2();
  expect_no_trial();
  ASSERT_TRUE(system_.linearize());
  expect_no_trial();
  system_.try_step(any_step());
  system_.reject();
  expect_no_trial();
  EXPECT_EQ(system_.chi2(), chi2);
  const double moved = system_.try_step(any_step());
  system_.accept();
  expect_no_trial();
  EXPECT_EQ(system_.chi2(), moved);
}

TEST_P(SystemContract, RefusesVectorsOfAnotherSize) {
  ASSERT_TRUE(system_.linearize());
  const double chi2 = system_.chi2();
  const std::string expected =
      "expected a vector of " + std::to_string(zeros().size()) + " entries, got " + std::to_string(7);
  std::vector<double> wrong(7);
  expect_refusal([&] { (void)system_.solve(kDamped, wrong); }, expected.c_str());
  expect_refusal([&] { system_.curvature(wrong); }, expected.c_str());
  expect_refusal([&] { system_.try_step(wrong); }, expected.c_str());
  EXPECT_EQ(system_.chi2(), chi2);
}

TEST_P(SystemContract, KeepsSpansUntilTheNextLinearization) {
  ASSERT_TRUE(system_.linearize());
  const std::span<const double> gradient = system_.gradient(), diagonal = system_.diagonal();
  const std::vector<double> old_gradient = copy(gradient), old_diagonal = copy(diagonal);
  const auto expect_the_same = [&] {
    EXPECT_EQ(copy(gradient), old_gradient);
    EXPECT_EQ(copy(diagonal), old_diagonal);
  };
  system_.try_step(solve(kDamped));
  expect_the_same();
  system_.reject();
  solve(kUndamped);
  expect_the_same();
  stop_ = true;
  std::vector<double> step = zeros();
  EXPECT_EQ(system_.solve(kDamped, step).status, LinearStatus::kStopped);
  expect_the_same();
  stop_ = false;
  system_.try_step(solve(kDamped));
  system_.accept();
  expect_the_same();
}

TEST_P(SystemContract, FindsTheSameStepWhetherOrNotItsDampingIsExpected) {
  ASSERT_TRUE(system_.linearize());
  const std::vector<double> damped = solve(kDamped), undamped = solve(kUndamped);
  for (const StepDamping& announced : {kDamped, kUndamped, kByIdentity}) {
    system_.expect(announced);
    ASSERT_TRUE(system_.linearize());
    EXPECT_EQ(solve(kDamped), damped);
    EXPECT_EQ(solve(kUndamped), undamped);
  }
}

/// The damping of a point that is hardly measured depends on the largest entry of the diagonal.
TEST_P(SystemContract, FindsTheStepOfAPointThatIsHardlyMeasuredWhetherOrNotItsDampingIsExpected) {
  const std::vector<EdgeRef> edges = graph_.all_edges();
  const VertexRef point = graph_.vertices(edges[0])[1];
  std::vector<EdgeRef> weak, strong;
  for (const EdgeRef& edge : edges) (graph_.vertices(edge)[1] == point ? weak : strong).push_back(edge);
  for (const EdgeRef& edge : weak) graph_.set_information(edge, Information(1e-24));
  for (const double information : {1.0, 1e8, 1.0, 1e-8}) {
    for (const EdgeRef& edge : strong) graph_.set_information(edge, Information(information));
    system_.expect(kDamped);
    ASSERT_TRUE(system_.linearize());
    const std::vector<double> expected = solve(kDamped);
    ASSERT_TRUE(system_.linearize());
    EXPECT_EQ(solve(kDamped), expected) << information;
  }
}

TEST_P(SystemContract, ReturnsNoResultIfItIsStopped) {
  const double chi2 = system_.chi2();
  EXPECT_FALSE(system_.stopped());
  ASSERT_TRUE(system_.linearize());
  const std::vector<double> step = solve(kDamped);
  std::vector<double> other = zeros();
  stop_ = true;
  EXPECT_EQ(system_.solve(kDamped, other).status, LinearStatus::kStopped);
  EXPECT_FALSE(system_.stopped()) << "of the last linearize(), try_step() or chi2()";
  EXPECT_TRUE(std::isnan(system_.try_step(step)));
  EXPECT_TRUE(system_.stopped());
  system_.reject();
  EXPECT_TRUE(std::isnan(system_.chi2()));
  stop_ = false;
  EXPECT_EQ(system_.chi2(), chi2);
  EXPECT_FALSE(system_.stopped());
  EXPECT_EQ(solve(kDamped), step) << "the model is still that of the last linearize()";
}

TEST_P(SystemContract, HasNoModelAfterAStoppedLinearization) {
  for (const bool announced : {false, true}) {
    stop_ = true;
    if (announced) system_.expect(kDamped);
    EXPECT_FALSE(system_.linearize());
    EXPECT_TRUE(system_.stopped());
    stop_ = false;
    std::vector<double> step = zeros();
    EXPECT_EQ(system_.solve(kDamped, step).status, LinearStatus::kStopped);
    EXPECT_TRUE(std::isnan(system_.curvature(any_step())));
  }
  EXPECT_TRUE(system_.linearize());
  solve(kDamped);
}

TEST_P(SystemContract, ReportsAModelThatIsNotFinite) {
  const VertexRef point = graph_.vertices(graph_.all_edges()[0])[1];
  const VertexHandle<Vector3> handle = graph_.typed<Vector3>(point);
  const Vector3 good = graph_.estimate(handle);
  graph_.set_estimate(handle, Vector3(std::numeric_limits<double>::quiet_NaN(), 0, 0));
  std::vector<double> step = zeros();
  EXPECT_FALSE(system_.linearize());
  EXPECT_FALSE(system_.stopped());
  EXPECT_EQ(system_.solve(kDamped, step).status, LinearStatus::kNotFinite);
  graph_.set_estimate(handle, good);
  EXPECT_TRUE(system_.linearize());
  solve(kDamped);
}

/// Linearizes, takes a step, and then breaks the contract.
class CarelessAlgorithm final : public Algorithm {
 public:
  enum class Mistake : std::uint8_t { kSolvesAfterAccept, kForgetsToAccept, kRejects };

  explicit CarelessAlgorithm(Mistake mistake) : mistake_(mistake) {}
  std::string_view name() const override { return "careless"; }
  void reset(const Options&, std::size_t scalars) override { step_.assign(scalars, 0); }
  IterationOutcome iterate(System& system, double /*chi2*/, IterationRecord& /*record*/) override {
    const StepDamping damping{1e-3, Options::DampingScale::kDiagonal};
    if (!system.linearize() || system.solve(damping, step_).status != LinearStatus::kOk)
      return IterationOutcome::kNotFinite;
    (void)system.try_step(step_);
    if (mistake_ == Mistake::kForgetsToAccept) return IterationOutcome::kAccepted;
    if (mistake_ == Mistake::kRejects) {
      system.reject();
      return IterationOutcome::kAccepted;
    }
    system.accept();
    (void)system.solve(damping, step_);
    return IterationOutcome::kAccepted;
  }

 private:
  Mistake mistake_;
  std::vector<double> step_;
};

TEST(CarelessAlgorithms, AreRefusedWhateverIsStored) {
  using enum CarelessAlgorithm::Mistake;
  for (const bool numeric_jacobians : {true, false}) {  // with them, all columns are stored
    for (const int iterations : {1, 10}) {
      const Options options{.max_iterations = iterations, .numeric_jacobians = numeric_jacobians};
      Graph graph = large_bundle();
      CarelessAlgorithm solves(kSolvesAfterAccept), forgets(kForgetsToAccept), rejects(kRejects);
      EXPECT_THAT([&] { std::ignore = Optimizer(graph, options).run(solves); },
                  ThrowsMessage<InvalidArgument>(HasSubstr("System::solve: expected linearize()")));
      EXPECT_THAT([&] { std::ignore = Optimizer(graph, options).run(forgets); },
                  ThrowsMessage<InvalidArgument>(HasSubstr("expected accept() or reject()")));
      EXPECT_THAT([&] { std::ignore = Optimizer(graph, options).run(rejects); },
                  ThrowsMessage<InvalidArgument>(HasSubstr("expected a call of System::accept()")));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Bundle, SystemContract, every_storage(), name_of_storage);

}  // namespace
}  // namespace boxplus
