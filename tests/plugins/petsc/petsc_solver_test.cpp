// SPDX-License-Identifier: BSD-3-Clause
// The linear solvers of PETSc: the contract of LinearSolver, and graphs that end at the optimum of boxplus'
// own solvers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mpi.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <thread>

#include "boxplus/linear/make_linear_solver.h"
#include "boxplus/petsc/make_petsc_solver.h"
#include "boxplus/testing/simulate_bundle.h"
#include "linear/expect_solution.h"
#include "optimize/small_graphs.h"
#include "plugins/mpi_leaks.h"

namespace boxplus {
namespace {

using ::testing::HasSubstr;

constexpr const char* kJacobiCg = "-ksp_type cg -pc_type pbjacobi";
constexpr const char* kMumps = "-ksp_type preonly -pc_type cholesky -pc_factor_mat_solver_type mumps";

/// Factorizes and solves with a new solver.
Eigen::MatrixXd solve(const TestSystem& system, const std::string& options, const Eigen::MatrixXd& b,
                      const Damping& damping = {}, double tolerance = 1e-12) {
  const auto solver = make_petsc_solver(options);
  const AssembledSystem view = system.view();
  solver->analyze(system.structure, {});
  const SolveControl control{.relative_tolerance = tolerance};
  EXPECT_EQ(solver->factorize(view, damping, control).status, LinearStatus::kOk) << options;
  Eigen::MatrixXd x(b.rows(), b.cols());
  EXPECT_EQ(solver->solve(b.data(), static_cast<int>(b.cols()), x.data(), control).status, LinearStatus::kOk)
      << options;
  return x;
}

/// A grid of blocks of three scalars.
TestSystem grid_system(std::uint32_t side = 6) {
  std::mt19937 random(3);
  return random_system(std::vector<std::uint32_t>(side * side, 3), grid_edges(side, side), random);
}

struct PetscMethod : ::testing::TestWithParam<const char*> {};

TEST_P(PetscMethod, SolvesSystemsOfEqualBlocksAndOfMixedOnes) {
  TestSystem grid = grid_system();
  const Eigen::MatrixXd b = right_hand_sides(grid, 2);
  expect_solution(grid.dense(), solve(grid, GetParam(), b), b);
  if (std::string(GetParam()).find("pbjacobi") != std::string::npos) return;  // needs blocks of one size
  for (std::uint32_t seed = 0; seed < 5; ++seed) {
    TestSystem mixed = random_system(20, 10, seed);
    const Eigen::MatrixXd c = right_hand_sides(mixed, 1);
    expect_solution(mixed.dense(), solve(mixed, GetParam(), c), c);
  }
}

TEST_P(PetscMethod, AddsTheDampingWithoutChangingTheSystem) {
  TestSystem system = grid_system();
  const std::vector<double> before = system.values;
  std::vector<double> diagonal(system.structure.scalars());
  for (std::size_t i = 0; i < diagonal.size(); ++i) diagonal[i] = 1 + static_cast<double>(i % 5);
  const Eigen::MatrixXd b = right_hand_sides(system, 1);
  const Eigen::MatrixXd x = solve(system, GetParam(), b, {0.5, diagonal.data()});
  EXPECT_EQ(system.values, before);
  Eigen::MatrixXd a = system.dense();
  for (Eigen::Index i = 0; i < a.rows(); ++i) a(i, i) += 0.5 * diagonal[static_cast<std::size_t>(i)];
  expect_solution(a, x, b);
}

TEST_P(PetscMethod, FactorizesAnewForEachDampingAndSystem) {
  TestSystem system = grid_system();
  const Eigen::MatrixXd b = right_hand_sides(system, 1);
  const auto solver = make_petsc_solver(GetParam());
  solver->analyze(system.structure, {});
  const SolveControl control{.relative_tolerance = 1e-12};
  const auto solution = [&](const Damping& damping) {
    const AssembledSystem view = system.view();
    EXPECT_EQ(solver->factorize(view, damping, control).status, LinearStatus::kOk);
    Eigen::MatrixXd x = b;  // B and X may be the same memory
    EXPECT_EQ(solver->solve(x.data(), 1, x.data(), control).status, LinearStatus::kOk);
    return x;
  };
  const Eigen::MatrixXd first = solution({0.1});
  const Eigen::MatrixXd second = solution({10});
  EXPECT_EQ(solution({0.1}), first);
  EXPECT_EQ(solution({10}), second);
  for (double& value : system.values) value *= 2;
  expect_solution(system.dense(), solution({}), b);
}

TEST_P(PetscMethod, NamesTheBlockThatIsNotFinite) {
  TestSystem system = grid_system();
  const auto solver = make_petsc_solver(GetParam());
  solver->analyze(system.structure, {});
  const AssembledSystem view = system.view();
  ASSERT_EQ(solver->factorize(view, {}).status, LinearStatus::kOk);
  Eigen::MatrixXd b = right_hand_sides(system, 1);
  b(4) = std::numeric_limits<double>::infinity();
  EXPECT_EQ(solver->solve(b.data(), 1, b.data()).status, LinearStatus::kNotFinite);
  system.block(7, 7)(1, 1) = std::numeric_limits<double>::quiet_NaN();
  const FactorResult result = solver->factorize(view, {});
  EXPECT_EQ(result.status, LinearStatus::kNotFinite);
  EXPECT_EQ(result.failed_block, 7u);
}

TEST_P(PetscMethod, StopsAndContinues) {
  const TestSystem system = grid_system();
  const AssembledSystem view = system.view();
  const Eigen::MatrixXd b = right_hand_sides(system, 1);
  const auto solver = make_petsc_solver(GetParam());
  solver->analyze(system.structure, {});
  const std::atomic<bool> flag = true;
  const SolveControl stopped{.stop = StopToken(&flag)};
  Eigen::MatrixXd x(b.rows(), 1);
  EXPECT_EQ(solver->factorize(view, {}, stopped).status, LinearStatus::kStopped);
  ASSERT_EQ(solver->factorize(view, {}).status, LinearStatus::kOk);
  EXPECT_EQ(solver->solve(b.data(), 1, x.data(), stopped).status, LinearStatus::kStopped);
  EXPECT_EQ(solver->solve(b.data(), 1, x.data()).status, LinearStatus::kOk);
  EXPECT_THROW(solver->analyze(system.structure, {}, stopped.stop), Stopped);
}

TEST_P(PetscMethod, NamesTheScalarWhoseDiagonalEntryIsNegative) {
  TestSystem system = grid_system();
  system.block(9, 9)(1, 1) = -100;
  const auto solver = make_petsc_solver(GetParam());
  solver->analyze(system.structure, {});
  const AssembledSystem view = system.view();
  const FactorResult result = solver->factorize(view, {});
  EXPECT_EQ(result.status, LinearStatus::kNotPositiveDefinite);
  EXPECT_EQ(result.failed_block, 9u);
  EXPECT_EQ(result.failed_scalar, 28u);
  EXPECT_EQ(solver->factorize(view, {200}).status, LinearStatus::kOk);
}

TEST_P(PetscMethod, ReachesTheOptimumOfTheOwnSolver) {
  const auto optimum = [](Graph& graph, std::shared_ptr<LinearSolver> solver) {
    Options options;
    options.noise_tolerance = 0;
    options.custom_linear_solver = std::move(solver);
    const Report report = optimize(graph, options);
    EXPECT_TRUE(report.converged()) << report;
    return report.chi2_final;
  };
  const auto compare = [&](auto make) {
    Graph own = make(), other = make();
    const double chi2 = optimum(own, nullptr);
    EXPECT_NEAR(optimum(other, make_petsc_solver(GetParam())), chi2, 1e-9 * chi2);
  };
  compare([] {
    Graph graph;
    add_noisy_circle(graph, 40);
    return graph;
  });
  compare([] {
    Graph graph;
    add_noisy_grid(graph, 4);
    return graph;
  });
  compare([] {  // with points that are eliminated, so that PETSc solves for the cameras
    return simulate_bundle(BundleShape::kRing, {.cameras = 12, .points = 400}).graph;
  });
}

INSTANTIATE_TEST_SUITE_P(OfPetsc, PetscMethod,
                         ::testing::Values(kMumps, kJacobiCg, "-ksp_type cg -mat_type aij -pc_type jacobi",
                                           "-ksp_type preonly -pc_factor_mat_solver_type petsc",
                                           "-ksp_type gmres -pc_type ilu", "-pc_type icc"),
                         [](const auto& one) { return "Options" + std::to_string(one.index); });

TEST(PetscSolver, SaysThatAMatrixIsIndefinite) {
  TestSystem system = grid_system();
  system.block(10, 9)(1, 1) = 100;
  const Eigen::MatrixXd b = right_hand_sides(system, 1);
  for (const char* options : {kMumps, "-ksp_type preonly -pc_factor_mat_solver_type petsc", kJacobiCg}) {
    const auto solver = make_petsc_solver(options);
    solver->analyze(system.structure, {});
    const AssembledSystem view = system.view();
    LinearStatus status = solver->factorize(view, {}).status;
    Eigen::MatrixXd x(b.rows(), 1);
    if (status == LinearStatus::kOk && options == kJacobiCg)
      status = solver->solve(b.data(), 1, x.data()).status;
    EXPECT_EQ(status, LinearStatus::kNotPositiveDefinite) << options;
  }
}

TEST(PetscSolver, SaysThatADirectSolutionIsExact) {
  const TestSystem system = grid_system();
  const AssembledSystem view = system.view();
  const Eigen::MatrixXd b = right_hand_sides(system, 1);
  Eigen::MatrixXd x(b.rows(), 1);
  for (const char* options : {kMumps, kJacobiCg}) {
    const auto solver = make_petsc_solver(options);
    solver->analyze(system.structure, {});
    ASSERT_EQ(solver->factorize(view, {}).status, LinearStatus::kOk);
    EXPECT_EQ(solver->solve(b.data(), 1, x.data()).exact, options == kMumps);
    EXPECT_EQ(solver->statistics().factor_nonzeros > 0, options == kMumps);
  }
}

TEST(PetscSolver, FactorizesWithMumpsByDefault) {
  const TestSystem system = grid_system(12);
  const AssembledSystem view = system.view();
  const auto values_in_factor = [&](const std::string& options) {
    const auto solver = make_petsc_solver(options);
    solver->analyze(system.structure, {});
    EXPECT_EQ(solver->factorize(view, {}).status, LinearStatus::kOk);
    return solver->statistics().factor_nonzeros;
  };
  const std::uint64_t values = values_in_factor(kMumps);
  EXPECT_GT(values, 0u);
  EXPECT_EQ(values_in_factor(""), values);
  EXPECT_EQ(values_in_factor("-ksp_type preonly"), values);
  EXPECT_NE(values_in_factor("-ksp_type preonly -pc_factor_mat_solver_type petsc"), values);
}

TEST(PetscSolver, SolvesOnlyToTheToleranceOfAnInexactStep) {
  TestSystem system = grid_system(12);
  const Eigen::MatrixXd b = right_hand_sides(system, 1), a = system.dense();
  const auto residual = [&](double tolerance) {
    return (a * solve(system, kJacobiCg, b, {}, tolerance) - b).norm() / b.norm();
  };
  const double rough = residual(0.1), fine = residual(1e-8);
  EXPECT_LE(rough, 0.1);
  EXPECT_GT(rough, 1e-4);
  EXPECT_LE(fine, 1e-8);
}

TEST(PetscSolver, IsNotConvergedAtTheLimitOfIterations) {
  const TestSystem system = grid_system(12);
  const AssembledSystem view = system.view();
  const Eigen::MatrixXd b = right_hand_sides(system, 1);
  const auto solver = make_petsc_solver(kJacobiCg);
  solver->analyze(system.structure, {});
  ASSERT_EQ(solver->factorize(view, {}).status, LinearStatus::kOk);
  Eigen::MatrixXd x(b.rows(), 1);
  const SolveResult result = solver->solve(b.data(), 1, x.data(), {.max_iterations = 2});
  EXPECT_EQ(result.status, LinearStatus::kNotConverged);
  EXPECT_EQ(result.iterations, 2);
  EXPECT_FALSE(result.exact);
}

/// The sum over the edges of a grid, without a prior: adding a constant to all blocks changes no error.
TestSystem floating_system() {
  TestSystem system(std::vector<std::uint32_t>(25, 2), grid_edges(5, 5));
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(2, 2);
  for (const BlockCoordinate& edge : grid_edges(5, 5)) system.add_edge(edge.row, edge.column, one, -one);
  return system;
}

TEST(PetscSolver, NamesThePivotThatVanishesIfTheMatrixMayBeSingular) {
  TestSystem system = floating_system();
  const AssembledSystem view = system.view();
  const std::vector<std::uint32_t> last{8};
  const auto solver = make_petsc_solver(kMumps);
  solver->analyze(system.structure, {.last = last, .may_be_singular = true});
  const FactorResult result = solver->factorize(view, {});
  EXPECT_EQ(result.status, LinearStatus::kNotPositiveDefinite);
  if (result.failed_block != BlockStructure::kAbsent) {
    EXPECT_EQ(result.failed_block, 8u);
    EXPECT_EQ(result.failed_scalar / 2, 8u);
  }
  EXPECT_EQ(solver->factorize(view, {1e-3}).status, LinearStatus::kOk);
  system.block(3, 3)(0, 0) += 1;  // now only the second scalar of all blocks is free
  const FactorResult second = solver->factorize(view, {});
  EXPECT_EQ(second.status, LinearStatus::kNotPositiveDefinite);
  if (second.failed_scalar != BlockStructure::kAbsent) {
    EXPECT_EQ(second.failed_scalar, 17u);
  }
}

TEST(PetscSolver, FactorizesAgainAfterASingularMatrix) {
  TestSystem system(std::vector<std::uint32_t>(2, 1), std::vector<BlockCoordinate>{{1, 0}});
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(1, 1);
  system.add_edge(1, 0, one, -one);
  const AssembledSystem view = system.view();
  const auto solver = make_petsc_solver(kMumps);
  solver->analyze(system.structure, {});
  EXPECT_EQ(solver->factorize(view, {}).status, LinearStatus::kNotPositiveDefinite);
  ASSERT_EQ(solver->factorize(view, {1.0}).status, LinearStatus::kOk);
  const double b[] = {3, 0};
  double x[2];
  EXPECT_EQ(solver->solve(b, 1, x).status, LinearStatus::kOk);
  EXPECT_NEAR(x[0], 2, 1e-12);
  EXPECT_NEAR(x[1], 1, 1e-12);
}

TEST(PetscSolver, SaysThatAGraphHasADirectionThatNothingMeasures) {
  Graph graph;
  using Bias = Vector<double, 4>;
  const auto a = graph.add_vertex(Bias(0, 0, 0, 0)), b = graph.add_vertex(Bias(1, 1, 1, 1), 77);
  graph.fix(a);
  graph.add_edge([](const auto& x, const auto& y) { return y[0] - x[0] - 1.5; }, a, b);
  graph.add_edge([](const auto& y) { return y[0] - 2.0; }, b);
  Options options;
  options.algorithm = AlgorithmKind::kGaussNewton;
  options.custom_linear_solver = make_petsc_solver();
  const Report singular = optimize(graph, options);
  EXPECT_EQ(singular.status, Report::Status::kFailed);
  EXPECT_EQ(singular.reason, Report::Reason::kNotPositiveDefinite);
  EXPECT_THAT(singular.message, HasSubstr("vertex 77"));
}

TEST(PetscSolver, RefusesOptionsThatPetscDoesNotKnow) {
  const TestSystem system = grid_system();
  const auto message_for = [&](const std::string& options) {
    try {
      const auto solver = make_petsc_solver(options);
      solver->analyze(system.structure, {});
      const AssembledSystem view = system.view();
      (void)solver->factorize(view, {});
      const Eigen::MatrixXd b = right_hand_sides(system, 1);
      Eigen::MatrixXd x(b.rows(), 1);
      (void)solver->solve(b.data(), 1, x.data());
    } catch (const InvalidArgument& error) {
      return std::string(error.what());
    }
    return std::string("no InvalidArgument");
  };
  EXPECT_THAT(message_for("cg"), HasSubstr("expected a name such as -ksp_type, got 'cg'"));
  EXPECT_THAT(message_for("-ksp_type cg gmres"), HasSubstr("got 'gmres'"));
  EXPECT_THAT(message_for("-ksp_type cq"), HasSubstr("cq"));
  EXPECT_THAT(message_for("-pc_type cholewsky"), HasSubstr("cholewsky"));
  EXPECT_THAT(message_for("-mat_type blocky"), HasSubstr("blocky"));
  EXPECT_THAT(message_for("-ksp_type cg -ksp_max_it many"), HasSubstr("many"));
  EXPECT_THAT(message_for("-ksp_type cg -ksp_rtol nan"), HasSubstr("expected a number after -ksp_rtol"));
  EXPECT_THAT(message_for("-mat_block_size 2"), HasSubstr("-mat_block_size"));
  EXPECT_THAT(message_for("-ksp_max_it 3"), HasSubstr("-ksp_max_it"));  // preonly does not iterate
  EXPECT_THAT(message_for("-kps_type cg"), HasSubstr("-kps_type"));
  EXPECT_THAT(message_for("-pc_factor_mat_solver_type none_such -ksp_type preonly"), HasSubstr("none_such"));
}

TEST(PetscSolver, WorksAgainAfterAnError) {
  TestSystem system = grid_system();
  EXPECT_THROW(make_petsc_solver("-ksp_type cq")->analyze(system.structure, {}), InvalidArgument);
  const Eigen::MatrixXd b = right_hand_sides(system, 1);
  expect_solution(system.dense(), solve(system, kMumps, b), b);
}

TEST(PetscSolver, ServesSeveralThreadsAndOptionsAtOnce) {
  TestSystem system = grid_system();
  const Eigen::MatrixXd b = right_hand_sides(system, 1), a = system.dense();
  std::vector<std::thread> threads;
  for (const char* options : {kMumps, kJacobiCg, ""})
    threads.emplace_back([&, options] {
      for (int i = 0; i < 5; ++i) expect_solution(a, solve(system, options, b), b);
    });
  for (std::thread& thread : threads) thread.join();
}

/// Whether a new solver solves a system, or throws because PETSc cannot be called.
bool can_solve() {
  try {
    TestSystem system = grid_system();
    const Eigen::MatrixXd b = right_hand_sides(system, 1);
    return (system.dense() * solve(system, kMumps, b) - b).norm() < 1e-9;
  } catch (const InvalidArgument&) {
    throw;
  } catch (const Error&) {
    return false;
  }
}

// Death tests, because each needs a process of its own.
TEST(PetscDeathTest, ServesAProgramThatStartsAndEndsMpiItself) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto program = [] {
    MPI_Init(nullptr, nullptr);
    const bool can_before = can_solve();
    MPI_Finalize();
    std::exit(can_before && !can_solve() ? 7 : 1);
  };
  EXPECT_EXIT(program(), ::testing::ExitedWithCode(7), "^$");
}

TEST(PetscDeathTest, MayOutliveMainAndPrintsNothing) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto program = [] {
    static std::unique_ptr<LinearSolver> late = make_petsc_solver();
    const TestSystem system = grid_system();
    late->analyze(system.structure, {});
    std::exit(late->factorize(system.view(), {}).status == LinearStatus::kOk ? 7 : 1);
  };
  EXPECT_EXIT(program(), ::testing::ExitedWithCode(7), "^$");
}

TEST(PetscSolver, OfNothingIsDone) {
  const TestSystem system({}, {});
  EXPECT_EQ(solve(system, "", Eigen::MatrixXd(0, 1)).size(), 0);
}

TEST(PetscSolver, ExpectsTheCallsOfItsContract) {
  const TestSystem system = grid_system();
  const auto solver = make_petsc_solver();
  EXPECT_THROW((void)solver->factorize(system.view(), {}), InvalidArgument);
  double x = 0;
  EXPECT_THROW((void)solver->solve(&x, 1, &x), InvalidArgument);
}

}  // namespace
}  // namespace boxplus
