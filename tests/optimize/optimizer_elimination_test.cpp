// SPDX-License-Identifier: BSD-3-Clause
// With elimination, optimize() finds the same optimum as without elimination. The result has the same bits
// for any number of threads.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "boxplus/optimize/optimizer.h"
#include "boxplus/robust/huber.h"
#include "linear/every_solver.h"
#include "linearize/bundle.h"

namespace boxplus {
namespace {

struct Way {
  SchurMode schur;
  LinearSolverKind solver;
};

/// Every solver with each form of the Schur complement that suits it.
std::vector<Way> ways() {
  std::vector<Way> all{{SchurMode::kAutomatic, LinearSolverKind::kAutomatic}};
  for (const detail::LinearSolverEntry& solver : every_solver()) {
    all.push_back({SchurMode::kExplicit, solver.kind});
    if (solver.make({})->needs() != LinearSolver::Needs::kBlocks)
      all.push_back({SchurMode::kImplicit, solver.kind});
  }
  return all;
}

class Elimination : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Cameras, Elimination, testing::Values(2, 5, 16),
                         ::testing::PrintToStringParamName());

TEST_P(Elimination, EndsAtTheSameChi2AsWithoutElimination) {
  Bundle plain = make_bundle(GetParam(), 200, false);
  const Report expected = optimize(plain.graph, {.cost_tolerance = 1e-13});
  EXPECT_EQ(expected.status, Report::Status::kConverged) << expected.message;
  EXPECT_LT(expected.chi2_final, 0.5 * expected.chi2_initial);
  for (const Way& way : ways()) {
    Bundle bundle = make_bundle(GetParam(), 200, true);
    const Options options{.linear_solver = way.solver, .schur = way.schur, .cost_tolerance = 1e-13};
    const Report report = optimize(bundle.graph, options);
    EXPECT_EQ(report.status, Report::Status::kConverged) << report.message;
    EXPECT_EQ(report.eliminated, 200u);
    EXPECT_NEAR(report.chi2_final, expected.chi2_final, 1e-9 * expected.chi2_final)
        << to_string(way.solver) << " " << static_cast<int>(way.schur);
  }
}

std::vector<double> all_estimates(const Bundle& bundle) {
  std::vector<double> values;
  for (const auto& camera : bundle.cameras) {
    const double* data = bundle.graph.estimate(camera).data();
    values.insert(values.end(), data, data + 7);
  }
  for (const auto& point : bundle.points) {
    const Eigen::Vector3d& p = bundle.graph.estimate(point);
    values.insert(values.end(), p.data(), p.data() + 3);
  }
  return values;
}

TEST(Elimination, ComputesTheSameBitsForAnyNumberOfThreads) {
  for (const Way& way : ways()) {
    std::vector<double> reference;
    for (const int threads : {1, 2, 3}) {
      Bundle bundle = make_bundle(16, 200, true);
      Options options{.linear_solver = way.solver, .schur = way.schur};
      options.threads = threads;
      options.max_iterations = 5;
      const Report report = optimize(bundle.graph, options);
      EXPECT_EQ(report.workers, threads);
      const std::vector<double> values = all_estimates(bundle);
      if (threads == 1) reference = values;
      EXPECT_EQ(std::memcmp(values.data(), reference.data(), values.size() * sizeof(double)), 0)
          << to_string(way.solver) << " with " << threads << " threads";
    }
  }
}

TEST(Elimination, OfAllVerticesConverges) {
  Bundle bundle = make_bundle(3, 30, true);
  for (const auto& camera : bundle.cameras) bundle.graph.fix(camera);
  const Report report = optimize(bundle.graph, {.algorithm = AlgorithmKind::kGaussNewton});
  EXPECT_EQ(report.status, Report::Status::kConverged) << report.message;
  EXPECT_EQ(report.eliminated, 30u);
}

TEST(Elimination, NamesThePointThatOnlyOneCameraSees) {
  Bundle bundle = make_bundle(3, 30, true);
  const auto lonely = bundle.graph.add_vertex(Eigen::Vector3d(1, 0.5, 8), 777);
  bundle.graph.set_eliminated(lonely, true);
  bundle.graph.add_edge(Reprojection{10, 20}, bundle.cameras[1], lonely);
  const Report report = optimize(bundle.graph, {.algorithm = AlgorithmKind::kGaussNewton});
  EXPECT_EQ(report.reason, Report::Reason::kNotPositiveDefinite);
  EXPECT_THAT(report.message, testing::HasSubstr("777"));
  EXPECT_EQ(optimize(bundle.graph).status, Report::Status::kConverged);  // the default algorithm damps H
}

TEST(Elimination, OfTwoVerticesOfTheSameEdgeIsRefused) {
  Bundle bundle = make_bundle(3, 30, true);
  bundle.graph.set_eliminated(bundle.cameras[2], true);
  EXPECT_THROW((void)optimize(bundle.graph), InvalidArgument);
  bundle.graph.set_eliminated(bundle.cameras[2], false);
  EXPECT_EQ(optimize(bundle.graph).status, Report::Status::kConverged);
}

TEST(Elimination, RunsAgainAfterTheGraphWasMoved) {
  Bundle bundle = make_bundle(3, 30, true);
  const Report first = optimize(bundle.graph);
  Graph moved(std::move(bundle.graph));
  const auto camera = bundle.cameras[2];
  SE3 shifted = moved.estimate(camera);
  const Vector<double, 6> shift = Vector<double, 6>::Constant(0.01);
  moved.set_estimate(camera, Manifold<SE3>::oplus(shifted, shift.data()));
  const Report second = optimize(moved);
  EXPECT_NEAR(second.chi2_final, first.chi2_final, 1e-7 * first.chi2_final);
  EXPECT_NEAR(moved.chi2(), second.chi2_final, 1e-9 * second.chi2_final);
}

}  // namespace
}  // namespace boxplus
