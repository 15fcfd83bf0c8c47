// SPDX-License-Identifier: BSD-3-Clause
// What boxplus/linear/linear_solver.h promises, on the system of a bundle adjustment problem: for every
// solver, alone and after an elimination of the points, whose Schur complement is stored or not, and has
// blocks that are joined or not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "allocation_counter.h"
#include "boxplus/testing/simulate_bundle.h"
#include "linear/every_solver.h"
#include "linear/schur/schur_solver.h"
#include "linearize/linearizer.h"

namespace boxplus {
namespace {

enum class Elimination : std::uint8_t { kNone, kStored, kImplicit, kJoined, kImplicitJoined };
constexpr std::array kEliminations{Elimination::kNone, Elimination::kStored, Elimination::kImplicit,
                                   Elimination::kJoined, Elimination::kImplicitJoined};
bool is_stored(Elimination elimination) {
  return elimination == Elimination::kStored || elimination == Elimination::kJoined;
}
bool is_joined(Elimination elimination) {
  return elimination == Elimination::kJoined || elimination == Elimination::kImplicitJoined;
}

struct Candidate {
  detail::LinearSolverEntry solver;
  Precision precision = Precision::kDouble;
  Elimination elimination = Elimination::kNone;
};

std::unique_ptr<LinearSolver> make_inner(const Candidate& candidate) {
  return candidate.solver.make({.block_cholesky = {.precision = candidate.precision}});
}

std::shared_ptr<LinearSolver> make(const Candidate& candidate) {
  std::shared_ptr<LinearSolver> solver = make_inner(candidate);
  if (candidate.elimination == Elimination::kNone) return solver;
  const SchurMode mode = is_stored(candidate.elimination) ? SchurMode::kExplicit : SchurMode::kImplicit;
  if (!is_joined(candidate.elimination)) return make_schur_solver(std::move(solver), mode);
  return std::make_shared<SchurSolver>(std::move(solver), mode, KeptBlocks::kJoined);
}

/// H and the gradient of a bundle adjustment problem at its initial estimates.
struct Bundle {
  BundleSimulation simulation;
  Plan plan = make_plan(simulation.graph, {});
  Linearizer linearizer{simulation.graph, plan};
  std::vector<double> b, diagonal, stiffness;

  explicit Bundle(BundleIntrinsics intrinsics)
      : simulation(
            simulate_bundle(BundleShape::kRing, {.cameras = 12, .points = 1000, .intrinsics = intrinsics})) {
    linearizer.linearize({});
    for (const double entry : linearizer.gradient()) b.push_back(-entry);
    for (std::uint32_t block = 0; block < plan.structure.blocks(); ++block) {
      const std::uint32_t dim = plan.structure.dim(block);
      for (std::uint32_t i = 0; i < dim; ++i)
        diagonal.push_back(linearizer.values()[plan.first_value(block) + i * (dim + 1)]);
    }
  }
};

/// If blocks are to be joined, each camera has two vertices.
const Bundle& bundle_for(Elimination elimination) {
  static Bundle whole(BundleIntrinsics::kWithPose), separate(BundleIntrinsics::kSeparate);
  return is_joined(elimination) ? separate : whole;
}

/// The parameters are the solver and the number of threads.
struct LinearSolverContract : ::testing::TestWithParam<std::tuple<Candidate, int>> {
  static const Candidate& candidate() { return std::get<0>(GetParam()); }
  static bool is_iterative() {
    return candidate().solver.method == detail::LinearSolverEntry::Method::kIterative;
  }
  static bool is_exact() { return !is_iterative() && candidate().precision != Precision::kMixed; }

  AnalyzeHints hints(int threads = std::get<1>(GetParam())) const {
    return {.right_hand_sides = 2,
            .threads = threads,
            .eliminated_blocks =
                candidate().elimination == Elimination::kNone ? 0 : bundle.plan.eliminated_blocks};
  }

  LinearSolverContract() { solver->analyze(structure, hints()); }

  std::vector<double> solve(LinearSolver& by, int columns = 1) {
    std::vector<double> x(b.size());
    EXPECT_EQ(by.solve(b.data(), columns, x.data(), control).status, LinearStatus::kOk);
    return x;
  }
  std::vector<double> factorize_and_solve(LinearSolver& by, const Damping& with) {
    EXPECT_EQ(by.factorize(system, with, control).status, LinearStatus::kOk);
    return solve(by);
  }
  /// (A + λD) x.
  Eigen::VectorXd multiply(const std::vector<double>& x, const Damping& with) const {
    Eigen::VectorXd y(static_cast<Eigen::Index>(x.size()));
    system.multiply(x.data(), y.data());
    for (std::uint32_t i = 0; i < structure.scalars(); ++i) y[i] += with(i) * x[i];
    return y;
  }
  static Eigen::Map<const Eigen::VectorXd> as_vector(const std::vector<double>& x) {
    return {x.data(), static_cast<Eigen::Index>(x.size())};
  }
  /// Makes a scalar of a diagonal block negative.
  void spoil(std::uint32_t block, double value) { values[bundle.plan.first_value(block)] = value; }

  const Bundle& bundle = bundle_for(candidate().elimination);
  const BlockStructure& structure = bundle.plan.structure;
  std::vector<double> values{bundle.linearizer.values().begin(), bundle.linearizer.values().end()};
  std::vector<double> b = bundle.b;
  AssembledSystem system{structure, values};
  const Damping damping{1e-2, bundle.diagonal.data()}, other{30};
  SolveControl control{.relative_tolerance = 1e-11};
  std::shared_ptr<LinearSolver> solver = make(candidate());
};

TEST_P(LinearSolverContract, SolvesTheDampedSystemToTheTolerance) {
  for (const Damping& with : {damping, other}) {
    const std::vector<double> x = factorize_and_solve(*solver, with);
    const double residual = (multiply(x, with) - as_vector(b)).norm();
    EXPECT_LE(residual, 1.01 * control.relative_tolerance * as_vector(b).norm());
  }
}

TEST_P(LinearSolverContract, SolvesAnyNumberOfTimesAfterAFactorization) {
  const std::vector<double> x = factorize_and_solve(*solver, damping);
  EXPECT_EQ(solve(*solver), x);
  EXPECT_EQ(solve(*solver), x);
}

TEST_P(LinearSolverContract, FactorizesOncePerDamping) {
  const std::vector<double> x = factorize_and_solve(*solver, damping),
                            y = factorize_and_solve(*solver, other);
  EXPECT_EQ(factorize_and_solve(*solver, damping), x);
  EXPECT_EQ(factorize_and_solve(*solver, other), y);
}

TEST_P(LinearSolverContract, ComputesTheSameBitsInEveryRunForAnyNumberOfThreads) {
  const std::vector<double> x = factorize_and_solve(*solver, damping);
  const std::shared_ptr<LinearSolver> alone = make(candidate());
  alone->analyze(structure, hints(1));
  EXPECT_EQ(factorize_and_solve(*alone, damping), x);
  solver->analyze(structure, hints());
  EXPECT_EQ(factorize_and_solve(*solver, damping), x);
}

TEST_P(LinearSolverContract, UsesTheRightHandSideThatIsAnnounced) {
  const std::vector<double> x = factorize_and_solve(*solver, damping);
  control.right_hand_side = b.data();
  EXPECT_EQ(factorize_and_solve(*solver, damping), x);
  EXPECT_EQ(solve(*solver), x);
}

TEST_P(LinearSolverContract, SolvesForSeveralRightHandSidesInTheirOwnMemory) {
  const std::vector<double> x = factorize_and_solve(*solver, damping);
  std::vector<double> columns = b;
  for (const double entry : b) columns.push_back(-2 * entry);
  for (int k = 0; k < 2; ++k) {
    std::vector<double> both = columns;
    ASSERT_EQ(solver->solve(both.data(), 2, both.data(), control).status, LinearStatus::kOk);
    const auto size = static_cast<Eigen::Index>(x.size());
    EXPECT_LT((as_vector(both).head(size) - as_vector(x)).norm(), 1e-8 * as_vector(x).norm());
    EXPECT_LT((as_vector(both).tail(size) + 2 * as_vector(x)).norm(), 2e-8 * as_vector(x).norm());
  }
}

TEST_P(LinearSolverContract, CallsASolutionExactOnlyIfItSatisfiesTheSystem) {
  ASSERT_EQ(solver->factorize(system, damping, control).status, LinearStatus::kOk);
  std::vector<double> x(b.size());
  const SolveResult result = solver->solve(b.data(), 1, x.data(), control);
  EXPECT_EQ(result.exact, is_exact());
  if (!result.exact) return;
  const double slope = as_vector(b).dot(as_vector(x));
  EXPECT_NEAR(as_vector(x).dot(multiply(x, damping)), slope, 1e-12 * slope);
}

TEST_P(LinearSolverContract, AllocatesOnlyInTheFirstFactorizationAndSolution) {
  if (!testing::allocations_are_counted()) GTEST_SKIP() << "a sanitizer has its own allocator";
  if (candidate().solver.allocates_in_every_call) GTEST_SKIP() << "its library allocates";
  factorize_and_solve(*solver, damping);
  std::vector<double> x(b.size());
  const long before = testing::allocation_count();
  for (const Damping& with : {other, damping}) {
    (void)solver->factorize(system, with, control);
    (void)solver->solve(b.data(), 1, x.data(), control);
  }
  EXPECT_EQ(testing::allocation_count() - before, 0);
}

TEST_P(LinearSolverContract, StopsAndContinuesWithTheSameBits) {
  const std::vector<double> x = factorize_and_solve(*solver, damping);
  const std::atomic<bool> flag = true;
  const SolveControl stopped{.relative_tolerance = 1e-11, .stop = StopToken(&flag)};
  std::vector<double> y(b.size());
  EXPECT_EQ(solver->solve(b.data(), 1, y.data(), stopped).status, LinearStatus::kStopped);
  EXPECT_EQ(solve(*solver), x);
  EXPECT_EQ(solver->factorize(system, damping, stopped).status, LinearStatus::kStopped);
  EXPECT_EQ(factorize_and_solve(*solver, damping), x);
}

TEST_P(LinearSolverContract, IsAnalyzedAgainAfterAStoppedAnalysis) {
  const std::vector<double> x = factorize_and_solve(*solver, damping);
  const std::atomic<bool> flag = true;
  try {
    solver->analyze(structure, hints(), StopToken(&flag));
  } catch (const Stopped&) {
    solver->analyze(structure, hints());
  }
  EXPECT_EQ(factorize_and_solve(*solver, damping), x);
}

TEST_P(LinearSolverContract, NamesTheBlockThatIsNotPositiveDefinite) {
  const std::uint32_t points = bundle.plan.eliminated_blocks;
  for (const std::uint32_t bad : {0u, points - 1, points, structure.blocks() - 1}) {
    const double good = values[bundle.plan.first_value(bad)];
    spoil(bad, -good);
    const FactorResult result = solver->factorize(system, damping, control);
    EXPECT_EQ(result.status, LinearStatus::kNotPositiveDefinite);
    EXPECT_EQ(result.failed_block, bad);
    if (result.failed_scalar != BlockStructure::kAbsent) {
      EXPECT_GE(result.failed_scalar, structure.offset[bad]);
      EXPECT_LT(result.failed_scalar, structure.offset[bad + 1]);
    }
    spoil(bad, good);
  }
}

TEST_P(LinearSolverContract, NamesTheBlockThatIsNotFinite) {
  const std::uint32_t points = bundle.plan.eliminated_blocks;
  for (const std::uint32_t bad : {0u, points - 1, points, structure.blocks() - 1}) {
    const double good = values[bundle.plan.first_value(bad)];
    spoil(bad, std::numeric_limits<double>::quiet_NaN());
    const FactorResult result = solver->factorize(system, damping, control);
    EXPECT_EQ(result.status, LinearStatus::kNotFinite);
    EXPECT_EQ(result.failed_block, bad);
    spoil(bad, good);
  }
  ASSERT_EQ(solver->factorize(system, damping, control).status, LinearStatus::kOk);
  b[b.size() - 2] = std::numeric_limits<double>::infinity();
  std::vector<double> x(b.size());
  EXPECT_EQ(solver->solve(b.data(), 1, x.data(), control).status, LinearStatus::kNotFinite);
}

TEST_P(LinearSolverContract, StopsAtTheLimitOfIterations) {
  control.max_iterations = 1;
  ASSERT_EQ(solver->factorize(system, damping, control).status, LinearStatus::kOk);
  std::vector<double> x(b.size());
  const SolveResult result = solver->solve(b.data(), 1, x.data(), control);
  if (!is_iterative()) return;
  EXPECT_EQ(result.status, LinearStatus::kNotConverged);
  EXPECT_EQ(result.iterations, 1);
  EXPECT_FALSE(result.exact);
}

TEST_P(LinearSolverContract, ComputesBlocksOfTheInverse) {
  ASSERT_EQ(solver->factorize(system, damping, control).status, LinearStatus::kOk);
  const std::uint32_t camera = structure.blocks() - 1;
  const std::vector<BlockCoordinate> blocks{{7, 7}, {camera, 7}, {camera, camera - 3}, {8, 7}};
  std::vector<double> inverse(9 + 27 + 81 + 9);
  if (!solver->selected_inverse(blocks, inverse.data())) {
    EXPECT_TRUE(is_iterative());
    return;
  }
  const double* block = inverse.data();
  for (const BlockCoordinate& at : blocks) {
    const std::uint32_t rows = structure.dim(at.row), columns = structure.dim(at.column);
    for (std::uint32_t c = 0; c < columns; ++c, block += rows) {
      std::vector<double> column(b.size(), 0.0);
      column[structure.offset[at.column] + c] = 1;
      ASSERT_EQ(solver->solve(column.data(), 1, column.data(), control).status, LinearStatus::kOk);
      const double size = as_vector(column).norm();
      for (std::uint32_t r = 0; r < rows; ++r)
        EXPECT_NEAR(block[r], column[structure.offset[at.row] + r], 1e-8 * size);
    }
  }
}

TEST_P(LinearSolverContract, EliminatesInTheOrderOfAnotherAnalysis) {
  const std::vector<std::uint32_t> order(solver->elimination_order().begin(),
                                         solver->elimination_order().end());
  const std::vector<double> x = factorize_and_solve(*solver, damping);
  AnalyzeHints ordered = hints();
  ordered.order = order;
  solver->analyze(structure, ordered);
  EXPECT_EQ(factorize_and_solve(*solver, damping), x);
  if (order.empty()) return;
  EXPECT_THAT(std::vector(solver->elimination_order().begin(), solver->elimination_order().end()), order);
  const std::vector<std::uint32_t> last{structure.blocks() - 5, 3};
  AnalyzeHints ending = hints();
  ending.last = last;
  solver->analyze(structure, ending);
  const std::span<const std::uint32_t> ends = solver->elimination_order();
  EXPECT_THAT(std::vector(ends.end() - 2, ends.end()), last);
}

TEST_P(LinearSolverContract, NamesThePivotThatVanishesIfTheMatrixMayBeSingular) {
  const std::uint32_t point = 5, scalar = structure.offset[point];
  for (std::uint32_t k = structure.column_start[point]; k < structure.column_start[point + 1]; ++k) {
    const std::uint32_t rows = structure.dim(structure.row[k]);
    std::fill_n(values.begin() + structure.value_start[k], rows, 0.0);  // the first column
    if (structure.row[k] != point) continue;
    for (std::uint32_t c = 0; c < rows; ++c) values[structure.value_start[k] + c * rows] = 0;
  }
  std::vector<double> diagonal = bundle.diagonal;
  diagonal[scalar] = 0;
  AnalyzeHints singular = hints();
  singular.may_be_singular = true;
  solver->analyze(structure, singular);
  const FactorResult result = solver->factorize(system, {1e-2, diagonal.data()}, control);
  EXPECT_EQ(result.status, LinearStatus::kNotPositiveDefinite);
  EXPECT_EQ(result.failed_block, point);
}

/// The dense solver only after an elimination, because H is large. A Schur complement that is not stored
/// suits only solvers that need products.
std::vector<Candidate> candidates() {
  std::vector<Candidate> all;
  const auto add = [&](const Candidate& candidate) {
    const bool is_large = candidate.elimination == Elimination::kNone;
    const bool has_blocks = is_large || is_stored(candidate.elimination);
    if (is_large && candidate.solver.kind == LinearSolverKind::kDense) return;
    if (!has_blocks && make_inner(candidate)->needs() == LinearSolver::Needs::kBlocks) return;
    all.push_back(candidate);
  };
  for (const Elimination elimination : kEliminations) {
    for (const detail::LinearSolverEntry& solver : every_solver()) {
      add({solver, Precision::kDouble, elimination});
      if (solver.kind == LinearSolverKind::kBlockCholesky) add({solver, Precision::kMixed, elimination});
    }
  }
  return all;
}

std::string name_of(const ::testing::TestParamInfo<std::tuple<Candidate, int>>& parameters) {
  const auto& [candidate, threads] = parameters.param;
  constexpr const char* kNames[] = {"", "_schur", "_implicit_schur", "_joined_schur",
                                    "_implicit_joined_schur"};
  return std::string(candidate.solver.name) + (candidate.precision == Precision::kMixed ? "_mixed" : "") +
         kNames[static_cast<int>(candidate.elimination)] + std::to_string(threads);
}

INSTANTIATE_TEST_SUITE_P(Bundle, LinearSolverContract,
                         ::testing::Combine(::testing::ValuesIn(candidates()), ::testing::Values(1, 3)),
                         name_of);

}  // namespace
}  // namespace boxplus
