// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <type_traits>

#include "optimize/small_graphs.h"

namespace boxplus {
namespace {

using testing::HasSubstr;

class EveryAlgorithm : public testing::TestWithParam<AlgorithmKind> {
 protected:
  Options options_{.algorithm = GetParam()};
};

TEST_P(EveryAlgorithm, ReachesTheSameOptimum) {
  Graph graph;
  add_noisy_grid(graph, 4);
  const Report report = optimize(graph, options_);
  EXPECT_TRUE(report.converged()) << report;
  Graph reference;
  add_noisy_grid(reference, 4);
  EXPECT_NEAR(report.chi2_final, optimize(reference).chi2_final, 1e-9 * report.chi2_final);
  EXPECT_DOUBLE_EQ(report.chi2_final, graph.chi2());
}

TEST_P(EveryAlgorithm, StopsAtTheIterationLimit) {
  Graph graph;
  add_noisy_grid(graph, 3);
  options_.max_iterations = 1;
  const Report report = optimize(graph, options_);
  EXPECT_EQ(report.status, Status::kNotConverged);
  EXPECT_EQ(report.reason, Reason::kMaxIterations);
  EXPECT_EQ(report.iterations, 1);
  EXPECT_EQ(report.records.size(), 1u);
  options_.max_iterations = 0;
  EXPECT_EQ(optimize(graph, options_).iterations, 0);
}

TEST_P(EveryAlgorithm, StopsWhenTheFlagIsUpAndKeepsTheEstimates) {
  Graph graph;
  add_noisy_grid(graph, 3);
  std::atomic<bool> stop = true;
  options_.stop = &stop;
  const double before = graph.chi2();
  const Report report = optimize(graph, options_);
  EXPECT_EQ(report.reason, Reason::kStopFlag);
  EXPECT_EQ(graph.chi2(), before);
}

TEST_P(EveryAlgorithm, StopsWhenTheCallbackSaysSo) {
  Graph graph;
  add_noisy_grid(graph, 3);
  int calls = 0;
  options_.cost_tolerance = options_.gradient_tolerance = 0;
  options_.callback = [&](const IterationRecord& record) {
    EXPECT_EQ(record.iteration, calls);
    return ++calls < 2;
  };
  const Report report = optimize(graph, options_);
  EXPECT_EQ(report.reason, Reason::kCallback);
  EXPECT_EQ(calls, 2);
}

TEST_P(EveryAlgorithm, RefusesACallbackThatChangesTheGraph) {
  Graph graph;
  add_noisy_grid(graph, 3);
  options_.callback = [&](const IterationRecord&) {
    graph.clear();
    return true;
  };
  EXPECT_THROW(optimize(graph, options_), InvalidArgument);
}

TEST_P(EveryAlgorithm, DoesNotDependOnTheUnitsOfTheInformation) {
  double chi2 = 0;
  for (const double unit : {1.0, 1e-16, 1e16}) {
    Graph graph;
    add_noisy_grid(graph, 3);
    for (const EdgeRef& edge : graph.all_edges()) graph.set_information(edge, 2500 * unit);
    const Report report = optimize(graph, options_);
    EXPECT_TRUE(report.converged()) << report;
    if (chi2 == 0) chi2 = report.chi2_final;
    EXPECT_NEAR(report.chi2_final / unit, chi2, 1e-8 * chi2);
  }
}

TEST_P(EveryAlgorithm, StopsAtTheTimeLimit) {
  Graph graph;
  add_noisy_grid(graph, 3);
  options_.time_limit_s = 0;
  EXPECT_EQ(optimize(graph, options_).reason, Reason::kTimeLimit);
}

TEST_P(EveryAlgorithm, MakesNoGuessOnceItIsToStop) {
  for (const Start start : {Start::kOdometry, Start::kSpanningTree, Start::kChordal, Start::kAutomatic}) {
    Graph graph;
    add_noisy_circle(graph, 30);
    const double before = graph.chi2();
    options_.start = start;
    const std::atomic<bool> stop = true;
    options_.stop = &stop;
    EXPECT_EQ(optimize(graph, options_).reason, Reason::kStopFlag);
    EXPECT_EQ(graph.chi2(), before);
    options_.stop = nullptr;
    options_.time_limit_s = 0;
    EXPECT_EQ(optimize(graph, options_).reason, Reason::kTimeLimit);
    EXPECT_EQ(graph.chi2(), before);
    options_.time_limit_s = 1e9;
  }
}

TEST_P(EveryAlgorithm, IsStoppedBetweenTheLinearisationAndTheStep) {
  for (const LinearSolverKind solver : {LinearSolverKind::kBlockCholesky, LinearSolverKind::kPcg}) {
    Graph graph;
    const auto poses = add_noisy_circle(graph, 10);
    std::atomic<bool> stop = false;
    graph.add_edge(
        [&stop]<class Pose>(const Pose& pose) {
          if constexpr (!std::is_same_v<Pose, SE2>) stop = true;  // derivatives are asked for
          return pose.x();
        },
        poses[4]);
    const double before = graph.chi2();
    options_.stop = &stop;
    options_.linear_solver = solver;
    const Report report = optimize(graph, options_);
    EXPECT_EQ(report.status, Status::kNotConverged);
    EXPECT_EQ(report.reason, Reason::kStopFlag);
    EXPECT_EQ(report.iterations, 0);
    EXPECT_EQ(graph.chi2(), before);
  }
}

TEST_P(EveryAlgorithm, CallsBackAfterTheLastIterationTooWithoutChangingTheReason) {
  Graph graph;
  add_noisy_grid(graph, 3);
  int calls = 0;
  options_.callback = [&](const IterationRecord&) { return ++calls > 0; };
  const Report report = optimize(graph, options_);
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_EQ(calls, report.iterations);
  options_.cost_tolerance = 1e30;
  options_.callback = [](const IterationRecord&) { return false; };
  EXPECT_EQ(optimize(graph, options_).status, Status::kConverged);
}

TEST_P(EveryAlgorithm, TakesPcgWhereTheFactorWouldNotFitIntoMemory) {
  for (const Start start : {Start::kCurrent, Start::kChordal}) {
    Graph direct, iterative;
    add_noisy_grid(direct, 4);
    add_noisy_grid(iterative, 4);
    options_.start = start;
    options_.max_factor_bytes = 0;
    const Report expected = optimize(direct, options_);
    EXPECT_EQ(expected.linear_solver, "block_cholesky");
    options_.max_factor_bytes = 1000;
    const Report report = optimize(iterative, options_);
    EXPECT_TRUE(report.converged()) << report;
    EXPECT_NEAR(report.chi2_final, expected.chi2_final, 1e-6 * expected.chi2_final);
    EXPECT_EQ(report.start.used, start);
    EXPECT_THAT(to_string(report), HasSubstr("pcg (since the factor would take "));
  }
}

TEST_P(EveryAlgorithm, StopsByGradientStepAndCost) {
  const auto reason_with = [&](double Options::*tolerance, double value) {
    Graph graph;
    add_noisy_grid(graph, 3);
    options_.cost_tolerance = options_.step_tolerance = options_.gradient_tolerance = 0;
    options_.*tolerance = value;
    return optimize(graph, options_).reason;
  };
  EXPECT_EQ(reason_with(&Options::cost_tolerance, 1e-3), Reason::kCostTolerance);
  EXPECT_EQ(reason_with(&Options::step_tolerance, 1e-3), Reason::kStepTolerance);
  EXPECT_EQ(reason_with(&Options::gradient_tolerance, 1e-1), Reason::kGradientTolerance);
}

TEST_P(EveryAlgorithm, NamesTheEdgeWhoseErrorIsNotANumber) {
  Graph graph;
  const auto poses = add_noisy_circle(graph, 10);
  graph.add_edge([](const auto& x) { return sqrt(x.x() - 1e6); }, poses[4]);
  const Report report = optimize(graph, options_);
  EXPECT_EQ(report.status, Status::kFailed);
  EXPECT_EQ(report.reason, Reason::kNotFinite);
  EXPECT_THAT(report.message, HasSubstr("between vertices 4 is NaN"));
}

TEST_P(EveryAlgorithm, NamesTheEdgeWhoseJacobianIsNotANumber) {
  Graph graph;
  const auto poses = add_noisy_circle(graph, 10);
  // √ has no derivative at 0.
  graph.add_edge([x = graph.estimate(poses[4]).x()](const auto& p) { return sqrt(p.x() - x); }, poses[4]);
  const Report report = optimize(graph, options_);
  EXPECT_EQ(report.status, Status::kFailed);
  EXPECT_THAT(report.message, HasSubstr("a Jacobian (or the weight of the robust kernel) of"));
  EXPECT_THAT(report.message, HasSubstr("between vertices 4 is NaN"));
}

TEST_P(EveryAlgorithm, LeavesTheEstimatesAloneWhenAnErrorFunctionThrows) {
  Graph graph;
  const auto poses = add_noisy_circle(graph, 10);
  const SE2 before = graph.estimate(poses[5]);
  graph.add_edge(
      [x = before.x()](const auto& p) {
        if (p.x() != x) throw std::runtime_error("the sensor is gone");
        return p.x();
      },
      poses[5]);
  options_.threads = 1;
  EXPECT_THROW(optimize(graph, options_), std::runtime_error);
  EXPECT_EQ(graph.estimate(poses[5]).vector(), before.vector());
}

INSTANTIATE_TEST_SUITE_P(Optimize, EveryAlgorithm,
                         testing::Values(AlgorithmKind::kGaussNewton, AlgorithmKind::kLevenbergMarquardt,
                                         AlgorithmKind::kDogleg));

TEST(Optimize, OfAnEmptyGraphHasNothingToDo) {
  Graph graph;
  const Report report = optimize(graph);
  EXPECT_TRUE(report.converged());
  EXPECT_EQ(report.reason, Reason::kNothingToOptimize);
}

TEST(Optimize, WithEverythingFixedReportsTheChi2) {
  Graph graph;
  for (const auto& pose : add_noisy_circle(graph, 5)) graph.fix(pose);
  const Report report = optimize(graph);
  EXPECT_EQ(report.reason, Reason::kNothingToOptimize);
  EXPECT_GT(report.chi2_final, 0);
}

TEST(Optimize, NamesTheVertexThatNothingMeasures) {
  Graph graph;
  const auto a = graph.add_vertex(Vector2(0, 0));
  const auto b = graph.add_vertex(Vector2(1, 1), 77);
  graph.fix(a);
  graph.add_edge([](const auto& x, const auto& y) { return y[0] - x[0] - 1.5; }, a, b);
  Options options;
  options.algorithm = AlgorithmKind::kGaussNewton;
  options.gauge = GaugePolicy::kFixFirst;
  const Report report = optimize(graph, options);
  // Its second coordinate is not observed: the component is held in one direction of two, so it is damped.
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_EQ(report.gauge.damped_components, 1);
  graph.add_edge([](const auto& y) { return y[0] - 2.0; }, b);  // two rows now, in one direction
  const Report singular = optimize(graph, options);
  EXPECT_EQ(singular.status, Status::kFailed);
  EXPECT_EQ(singular.reason, Reason::kNotPositiveDefinite);
  EXPECT_THAT(singular.message, HasSubstr("vertex 77"));
  // Dogleg damps H and says so.
  options.algorithm = AlgorithmKind::kDogleg;
  const Report damped = optimize(graph, options);
  EXPECT_TRUE(damped.converged()) << damped;
  EXPECT_GT(damped.regularised_steps, 0);
  EXPECT_NEAR(graph.estimate(b)[0], 1.75, 1e-6);
  EXPECT_EQ(graph.estimate(b)[1], 1);
}

TEST(Optimize, RefusesOptionsThatMakeNoSense) {
  Graph graph;
  add_noisy_circle(graph, 5);
  const auto with = [](auto set) {
    Options options;
    set(options);
    return options;
  };
  EXPECT_THROW(optimize(graph, with([](Options& o) { o.max_iterations = -1; })), InvalidArgument);
  EXPECT_THROW(optimize(graph, with([](Options& o) { o.threads = -1; })), InvalidArgument);
  EXPECT_THROW(optimize(graph, with([](Options& o) { o.cost_tolerance = std::nan(""); })), InvalidArgument);
  EXPECT_THROW(optimize(graph, with([](Options& o) { o.linear_tolerance = 0; })), InvalidArgument);
  EXPECT_THROW(optimize(graph, with([](Options& o) { o.vertices = {VertexRef{7, 7, 7}}; })), InvalidArgument);
}

TEST(Optimize, OfASubsetMovesOnlyItsVertices) {
  Graph graph;
  const auto poses = add_noisy_circle(graph, 20);
  Options options;
  options.vertices = {poses[3], poses[4]};
  const SE2 outside = graph.estimate(poses[5]), inside = graph.estimate(poses[4]);
  const Report report = optimize(graph, options);
  EXPECT_EQ(report.vertices, 2u);
  EXPECT_EQ(report.edges, 3u);
  EXPECT_EQ(graph.estimate(poses[5]).vector(), outside.vector());
  (void)inside;
  options.vertices.clear();
  options.edges = {graph.all_edges()[0], graph.all_edges()[1]};
  EXPECT_EQ(optimize(graph, options).edges, 2u);
}

TEST(Optimize, UsesTheEdgesOfOneLevel) {
  Graph graph;
  const auto x = graph.add_vertex(Vector<double, 1>(0.0));
  graph.add_edge([](const auto& v) { return v[0] - 1.0; }, x);
  const auto other = graph.add_edge([](const auto& v) { return v[0] - 5.0; }, x);
  graph.set_level(other, 1);
  optimize(graph);
  EXPECT_NEAR(graph.estimate(x)[0], 1, 1e-12);
  Options options;
  options.level = 1;
  optimize(graph, options);
  EXPECT_NEAR(graph.estimate(x)[0], 5, 1e-12);
  options.level = -1;
  optimize(graph, options);
  EXPECT_NEAR(graph.estimate(x)[0], 3, 1e-12);
}

TEST(Optimize, DifferentiatesFunctionsOfPlainEigenVectorsNumerically) {
  struct Plain {
    Eigen::Vector2d error(const Eigen::Vector2d& x) const { return x - Eigen::Vector2d(1, 2); }
  };
  Graph graph;
  const auto x = graph.add_vertex(Eigen::Vector2d(0, 0));
  graph.add_edge([](const Eigen::Vector2d& v) { return v[0] - 4; }, x);
  graph.add_edge(std::function<double(const Eigen::Vector2d&)>([](const auto& v) { return v[1]; }), x);
  graph.add_edge(Plain{}, x);
  const Report report = optimize(graph);
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_EQ(report.numeric_jacobians.size(), 3u);
  EXPECT_NEAR(graph.estimate(x)[0], 2.5, 1e-9);
  EXPECT_NEAR(graph.estimate(x)[1], 1, 1e-9);
}

TEST(Optimize, SaysWhichEdgesAreDifferentiatedNumerically) {
  Graph graph;
  const auto poses = add_noisy_circle(graph, 5);
  EXPECT_TRUE(optimize(graph).numeric_jacobians.empty());
  graph.add_edge([](const SE2& p) { return p.x(); }, poses[0]);
  EXPECT_EQ(optimize(graph).numeric_jacobians.size(), 1u);
  Options options;
  options.numeric_jacobians = true;
  EXPECT_EQ(optimize(graph, options).numeric_jacobians.size(), 2u);
}

TEST(Optimize, RejectsAnOutlierUnderARobustKernel) {
  Graph graph;
  const auto x = graph.add_vertex(Vector<double, 1>(3.0));
  for (int i = 0; i < 10; ++i) graph.add_edge([i](const auto& v) { return v[0] - (1.0 + 0.01 * i); }, x);
  const auto outlier = graph.add_edge([](const auto& v) { return v[0] - 100.0; }, x);
  for (const EdgeRef& edge : graph.all_edges()) graph.set_kernel(edge, Cauchy(0.1));
  EXPECT_TRUE(optimize(graph).converged());
  EXPECT_NEAR(graph.estimate(x)[0], 1.045, 0.01);
  graph.set_enabled(outlier, false);
  const Report report = optimize(graph);
  EXPECT_EQ(report.disabled_edges, 1u);
  EXPECT_TRUE(report.plan_reused);
}

TEST(Report, ShowsNoSignOfWhatIsNotANumber) {
  Report report;
  const double minus_nan = -std::numeric_limits<double>::quiet_NaN();
  report.chi2_initial = report.chi2_final = report.start.chi2_current = report.start.chi2_guess = minus_nan;
  report.records.push_back({.chi2 = minus_nan, .chi2_decrease = minus_nan});
  const std::string text = to_string(report);
  EXPECT_THAT(text, HasSubstr("chi2 nan → nan"));
  EXPECT_THAT(text, testing::Not(HasSubstr("-nan")));
}

TEST(Report, TellsInTwoDigitsWhatTheFactorWouldTake) {
  const auto text_for = [](std::uint64_t bytes) {
    Report report;
    report.linear.refused_factor_bytes = bytes;
    report.linear.factor_seconds = 254;
    report.linear.pcg_seconds = 0.31;
    return to_string(report);
  };
  EXPECT_THAT(text_for(40), HasSubstr("take 0.0 kB and"));
  EXPECT_THAT(text_for(999'600), HasSubstr("take 1.0 MB and"));
  EXPECT_THAT(text_for(61'400'000'000),
              HasSubstr("take 61 GB and 254 s each time, a rough solution 0.31 s)"));
  EXPECT_THAT(text_for(3'140'000'000'000'000), HasSubstr("take 3140 TB and"));
}

TEST(Report, ReadsAsATable) {
  Graph graph;
  add_noisy_circle(graph, 20);
  const std::string text = to_string(optimize(graph));
  EXPECT_THAT(text, HasSubstr("converged: chi2"));
  EXPECT_THAT(text, HasSubstr("because"));
  EXPECT_THAT(text, HasSubstr("gauge           0"));
  EXPECT_THAT(text, HasSubstr("dogleg, block_cholesky"));
}

/// x − z with a Jacobian of the wrong sign.
struct WrongJacobian {
  double measurement;
  double error(const double& x) const { return x - measurement; }
  template <class J>
  void jacobians(const double&, J& jacobian) const {
    jacobian(0, 0) = -1;
  }
};

TEST(Optimize, DoesNotCallItConvergedWhereNoStepDoesWhatItPromised) {
  for (const auto algorithm : {AlgorithmKind::kDogleg, AlgorithmKind::kLevenbergMarquardt}) {
    Graph graph;
    const auto x = graph.add_vertex(0.0);
    graph.add_edge(WrongJacobian{5}, x);
    const Report report = optimize(graph, {.algorithm = algorithm});
    EXPECT_EQ(report.status, Status::kNotConverged);
    EXPECT_EQ(report.reason, Reason::kNoStepFound);
    EXPECT_EQ(graph.estimate(x), 0.0);
  }
}

TEST(Optimize, IsNotConvergedWhereDampingOrRadiusCutEveryStepShort) {
  for (const double tightness : {1e6, 1e10, 1e14, 1e30, 1e300}) {
    const Options damped{.algorithm = AlgorithmKind::kLevenbergMarquardt,
                         .max_iterations = 3,
                         .cost_tolerance = 1e-3,
                         .initial_lambda = tightness};
    const Options bounded{.algorithm = AlgorithmKind::kDogleg,
                          .max_iterations = 3,
                          .cost_tolerance = 1e-3,
                          .initial_radius = 1 / tightness};
    for (const Options& options : {damped, bounded}) {
      Graph graph;
      add_noisy_grid(graph, 3);
      const Report report = optimize(graph, options);
      EXPECT_EQ(report.status, Status::kNotConverged) << report;
      EXPECT_EQ(report.reason, Reason::kMaxIterations);
    }
  }
}

TEST(Optimize, GetsAwayFromADampingOrARadiusThatPermitsNoStep) {
  Graph reference;
  add_noisy_grid(reference, 3);
  const double chi2 = optimize(reference).chi2_final;
  for (const DampingScale scale : {DampingScale::kIdentity, DampingScale::kDiagonal}) {
    const Options damped{
        .algorithm = AlgorithmKind::kLevenbergMarquardt, .damping = scale, .initial_lambda = 1e300};
    const Options bounded{.algorithm = AlgorithmKind::kDogleg, .initial_radius = 1e-300};
    for (const Options& options : {damped, bounded}) {
      Graph graph;
      add_noisy_grid(graph, 3);
      const Report report = optimize(graph, options);
      EXPECT_TRUE(report.converged()) << report;
      EXPECT_NEAR(report.chi2_final, chi2, 1e-8 * chi2);
    }
  }
}

TEST(Optimize, IsConvergedAtAMinimumHoweverDampedOrBounded) {
  for (const Options& options :
       {Options{.algorithm = AlgorithmKind::kLevenbergMarquardt, .initial_lambda = 1e300},
        Options{.algorithm = AlgorithmKind::kDogleg, .initial_radius = 1e-300}}) {
    Graph graph;
    add_noisy_grid(graph, 3);
    optimize(graph);
    const Report report = optimize(graph, options);
    EXPECT_TRUE(report.converged()) << report;
    EXPECT_LT(report.iterations, 3);
  }
}

TEST(Optimize, RefusesToBeCalledForItsGraphByItsCallback) {
  for (const auto algorithm : {AlgorithmKind::kDogleg, AlgorithmKind::kGaussNewton}) {
    Graph graph;
    add_noisy_circle(graph, 20);
    Options options{.algorithm = algorithm};
    options.callback = [&](const IterationRecord&) {
      optimize(graph);
      return true;
    };
    EXPECT_THROW(optimize(graph, options), InvalidArgument);
    options.callback = nullptr;
    EXPECT_TRUE(optimize(graph, options).converged()) << "the graph can be optimised again";
  }
}

TEST(Optimize, LeavesTheGraphUsableWhereAnErrorFunctionThrows) {
  Graph graph;
  const auto x = graph.add_vertex(1.0);
  bool throws = true;
  graph.add_edge(
      [&throws](const auto& value) {
        if (throws) throw std::runtime_error("no measurement");
        return value - 3;
      },
      x);
  EXPECT_THROW(optimize(graph), std::runtime_error);
  EXPECT_THROW(optimize(graph), std::runtime_error) << "not InvalidArgument";
  throws = false;
  EXPECT_TRUE(optimize(graph).converged());
}

TEST(Optimize, NamesAnEdgeWhereOnlyTheSumOverAllOverflows) {
  Graph graph;
  const auto x = graph.add_vertex(1e308, 7), y = graph.add_vertex(0.0, 8);
  graph.add_edge([](const auto& value) { return value - 1e308 - 3; }, x);
  graph.add_edge([](const auto& value) { return value - 1e154; }, y);
  graph.add_edge([](const auto& a, const auto& b) { return 1.2e-154 * a + b; }, x, y);
  const Report report = optimize(graph);
  EXPECT_EQ(report.reason, Reason::kNotFinite);
  EXPECT_THAT(report.message, HasSubstr("chi2 overflows; the largest part is that of the edge"));
  EXPECT_THAT(report.message, testing::EndsWith("between vertices 7 8"));
}

TEST(Optimize, NamesTheEdgeByWhichTheLinearSystemOverflows) {
  for (const auto algorithm :
       {AlgorithmKind::kDogleg, AlgorithmKind::kLevenbergMarquardt, AlgorithmKind::kGaussNewton}) {
    Graph graph;
    const auto x = graph.add_vertex(1.0, 7), y = graph.add_vertex(2.0, 8);
    graph.add_edge([](const auto& value) { return value - 3; }, x);
    graph.add_edge([](const auto& a, const auto& b) { return 1e300 * (2 * a - b); }, x, y);
    const Report report = optimize(graph, {.algorithm = algorithm});
    EXPECT_EQ(report.reason, Reason::kNotFinite);
    EXPECT_THAT(report.message, HasSubstr("the linear system overflows; the largest Jacobian"));
    EXPECT_THAT(report.message, testing::EndsWith("between vertices 7 8"));
  }
}

class NanWeight final : public RobustKernel {
 public:
  Rho operator()(double e2) const override { return {e2, std::nan(""), 0}; }
  std::string_view name() const override { return "NanWeight"; }
  double delta() const override { return 1; }
  std::unique_ptr<RobustKernel> clone() const override { return std::make_unique<NanWeight>(); }
};

TEST(Optimize, NamesAnEdgeWhoseKernelGivesNoNumber) {
  Graph graph;
  const auto x = graph.add_vertex(1.0);
  const auto edge = graph.add_edge([](const auto& value) { return value - 3; }, x);
  graph.set_kernel(edge, NanWeight());
  const Report report = optimize(graph);
  EXPECT_EQ(report.reason, Reason::kNotFinite);
  EXPECT_THAT(report.message, HasSubstr("the weight of the robust kernel"));
  EXPECT_THAT(report.message, HasSubstr("between vertices 0"));
}

}  // namespace
}  // namespace boxplus
