// SPDX-License-Identifier: BSD-3-Clause
// Compares the results of class Schur with a dense Schur complement of a dense H.
#include "linear/schur/schur.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "linear/test_system.h"
#include "linearize/bundle.h"
#include "linearize/dense_reference.h"

namespace boxplus {
namespace {

/// A linearized problem, its damping, and its Hessian as a dense matrix with and without damping.
struct Problem {
  Bundle bundle;
  Plan plan;
  Linearizer linearizer;
  Eigen::VectorXd diagonal;
  Damping damping;
  Eigen::MatrixXd hessian, damped;
  Eigen::Index eliminated;

  Problem(Bundle b, double lambda, bool scaled)
      : bundle(std::move(b)), plan(make_plan(bundle.graph, {})), linearizer(bundle.graph, plan) {
    linearizer.linearize({});
    hessian = dense_matrix(plan.structure, linearizer.values());
    diagonal = hessian.diagonal();
    damping = {lambda, scaled ? diagonal.data() : nullptr};
    damped = hessian;
    for (Eigen::Index i = 0; i < hessian.rows(); ++i) damped(i, i) += damping(static_cast<std::uint32_t>(i));
    eliminated = plan.structure.offset[plan.eliminated_blocks];
  }
  Problem(const Problem&) = delete;

  Eigen::Index kept() const { return hessian.rows() - eliminated; }
  AnalyzeHints hints(int threads = 1) const {
    return {.threads = threads, .eliminated_blocks = plan.eliminated_blocks};
  }
};

/// The results of dense matrices. They take most of the time, so each problem needs them only once.
struct Reference {
  /// The Schur complement U − W (V + λD)⁻¹ Wᵀ. The kept blocks U are not damped.
  Eigen::MatrixXd complement;
  Eigen::VectorXd r, x;  // a right-hand side, and the solution of the damped system

  explicit Reference(const Problem& problem) {
    const Eigen::Index kept = problem.kept(), eliminated = problem.eliminated;
    const Eigen::MatrixXd W = problem.hessian.bottomLeftCorner(kept, eliminated);
    const Eigen::MatrixXd V = problem.damped.topLeftCorner(eliminated, eliminated);
    complement = problem.hessian.bottomRightCorner(kept, kept) - W * V.llt().solve(W.transpose());
    r = Eigen::VectorXd::LinSpaced(problem.hessian.rows(), 1, 3);
    x = problem.damped.llt().solve(r);
  }
};

void check_values(const Reference& reference, Schur& schur) {
  const Eigen::MatrixXd& expected = reference.complement;
  const Eigen::MatrixXd actual = dense_matrix(schur.reduced_structure(), schur.reduced_values());
  EXPECT_LE((actual - expected).norm(), 1e-10 * expected.norm());
}

void check_operator(const Reference& reference, Schur& schur) {
  const Eigen::MatrixXd& expected = reference.complement;
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(expected.rows(), -1, 2);
  Eigen::VectorXd y(x.size());
  const ImplicitSchur implicit(schur);
  EXPECT_TRUE(implicit.values().empty());
  implicit.multiply(x.data(), y.data());
  EXPECT_LE((y - expected * x).norm(), 1e-10 * (expected * x).norm());
  const BlockStructure& structure = implicit.structure();
  std::size_t size = 0;
  for (std::uint32_t block = 0; block < structure.blocks(); ++block)
    size += std::size_t{structure.dim(block)} * structure.dim(block);
  std::vector<double> blocks(size);
  implicit.block_diagonal(blocks.data());
  const double* at = blocks.data();
  for (std::uint32_t block = 0; block < structure.blocks(); ++block) {
    const auto dim = static_cast<Eigen::Index>(structure.dim(block)),
               offset = static_cast<Eigen::Index>(structure.offset[block]);
    const Eigen::Map<const Eigen::MatrixXd> actual(at, dim, dim);
    EXPECT_LE((actual - expected.block(offset, offset, dim, dim)).norm(), 1e-10 * expected.norm());
    at += dim * dim;
  }
}

/// Checks that scalars which are left out have no effect, whatever their rows in W are.
void check_left_out_scalars(Problem& problem, Schur& schur) {
  const Eigen::Index kept = problem.kept();
  const std::vector<std::uint32_t> out{0, 2, static_cast<std::uint32_t>(kept - 1)};
  std::vector<std::uint32_t> scalars;
  for (const std::uint32_t i : out) scalars.push_back(static_cast<std::uint32_t>(problem.eliminated) + i);
  const Eigen::VectorXd r = Eigen::VectorXd::LinSpaced(problem.hessian.rows(), 1, 3);
  Eigen::VectorXd expected_r(kept), actual_r(kept);
  schur.eliminate(problem.linearizer.values(), problem.damping, {}, r.data(), expected_r.data());
  Eigen::MatrixXd expected = dense_matrix(schur.reduced_structure(), schur.reduced_values());
  for (const std::uint32_t i : out) {
    expected.row(i).setZero();
    expected.col(i).setZero();
    expected(i, i) = problem.hessian(problem.eliminated + i, problem.eliminated + i);
    expected_r[i] = 0;
  }
  schur.leave_out(scalars);
  schur.eliminate(problem.linearizer.values(), problem.damping, {}, r.data(), actual_r.data());
  EXPECT_EQ(dense_matrix(schur.reduced_structure(), schur.reduced_values()), expected);
  EXPECT_EQ(actual_r, expected_r);
  schur.leave_out({});
}

/// Checks that reduction, a dense solve and back substitution give the solution of the full system.
void check_solution(const Problem& problem, const Reference& reference, Schur& schur) {
  Eigen::VectorXd reduced_r(problem.kept()), x(reference.r.size());
  schur.reduce(reference.r.data(), reduced_r.data());
  Eigen::MatrixXd S = reference.complement;
  const Damping kept = schur.reduced_damping(problem.damping);
  for (Eigen::Index i = 0; i < S.rows(); ++i) S(i, i) += kept(static_cast<std::uint32_t>(i));
  const Eigen::VectorXd reduced_x = S.llt().solve(reduced_r);
  schur.back_substitute(reference.r.data(), reduced_x.data(), x.data());
  EXPECT_LE((x - reference.x).norm(), 1e-9 * reference.x.norm());
}

/// The forms of S: whether it is explicit, and its blocks.
constexpr std::pair<bool, KeptBlocks> kForms[] = {{true, KeptBlocks::kSeparate},
                                                  {true, KeptBlocks::kJoined},
                                                  {false, KeptBlocks::kSeparate},
                                                  {false, KeptBlocks::kJoined}};

void check_elimination(Problem& problem) {
  const std::vector<double> before(problem.linearizer.values().begin(), problem.linearizer.values().end());
  const Reference reference(problem);
  for (const auto& [explicit_values, kept] : kForms) {
    Schur schur(problem.plan.structure, problem.hints(), explicit_values, kept);
    // The second elimination must overwrite the results of the first one.
    for (int round = 0; round < 2; ++round) {
      ASSERT_EQ(schur.eliminate(problem.linearizer.values(), problem.damping).status, LinearStatus::kOk);
      EXPECT_EQ(schur.reduced_values().empty(), !explicit_values);
      if (explicit_values) check_values(reference, schur);
      check_operator(reference, schur);
      check_solution(problem, reference, schur);
      if (explicit_values && problem.kept() > 6) check_left_out_scalars(problem, schur);
    }
  }
  EXPECT_THAT(problem.linearizer.values(), testing::ElementsAreArray(before));
}

class SchurOfBundle : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Cameras, SchurOfBundle, testing::Values(2, 3, 5, 16),
                         ::testing::PrintToStringParamName());

TEST_P(SchurOfBundle, EqualsTheDenseComplementWithoutDamping) {
  Problem problem(make_bundle(GetParam(), 200, true), 0, false);
  EXPECT_EQ(problem.plan.eliminated_blocks, 200u);
  check_elimination(problem);
}

TEST_P(SchurOfBundle, EqualsTheDenseComplementWithIdentityDamping) {
  Problem problem(make_bundle(GetParam(), 200, true), 10, false);
  check_elimination(problem);
}

TEST_P(SchurOfBundle, EqualsTheDenseComplementWithDiagonalDamping) {
  Problem problem(make_bundle(GetParam(), 200, true), 0.1, true);
  check_elimination(problem);
}

/// All results of an elimination: S, the reduced right-hand side, the solution for given kept values, and a
/// product with S.
std::vector<double> results(const Problem& problem, std::pair<bool, KeptBlocks> form, int threads,
                            bool reduces_at_once) {
  Schur schur(problem.plan.structure, problem.hints(threads), form.first, form.second);
  const std::size_t size = problem.plan.structure.scalars(), kept = schur.reduced_structure().scalars();
  std::vector<double> r(size), reduced_r(kept), x(size);
  for (std::size_t i = 0; i < size; ++i) r[i] = std::sin(static_cast<double>(i));
  const double* known_r = reduces_at_once ? r.data() : nullptr;
  EXPECT_EQ(
      schur.eliminate(problem.linearizer.values(), problem.damping, {}, known_r, reduced_r.data()).status,
      LinearStatus::kOk);
  if (!reduces_at_once) schur.reduce(r.data(), reduced_r.data());
  schur.back_substitute(r.data(), r.data(), x.data());
  std::vector<double> product(kept);
  schur.multiply(r.data(), product.data());
  std::vector<double> all(schur.reduced_values().begin(), schur.reduced_values().end());
  all.insert(all.end(), reduced_r.begin(), reduced_r.end());
  all.insert(all.end(), x.begin(), x.end());
  all.insert(all.end(), product.begin(), product.end());
  return all;
}

TEST(Schur, HasTheSameBitsForAnyNumberOfThreadsWhetherOrNotEliminateAlsoReducesTheRightHandSide) {
  const Problem problem(make_bundle(12, 600, true), 0.1, true);
  for (const auto& form : kForms) {
    const std::vector<double> expected = results(problem, form, 1, false);
    for (const int threads : {1, 2, 3, 7, 64}) {
      EXPECT_EQ(results(problem, form, threads, false), expected) << threads;
      EXPECT_EQ(results(problem, form, threads, true), expected) << threads;
    }
  }
}

TEST(Schur, EliminatesColumnByColumnWithTheSameBits) {
  const Problem problem(make_bundle(12, 600, true), 0.1, true);
  const BlockStructure& structure = problem.plan.structure;
  std::vector<double> r(structure.scalars());
  for (std::size_t i = 0; i < r.size(); ++i) r[i] = std::sin(static_cast<double>(i));
  const std::vector<std::uint32_t> bounds{0, 64, 192, 256, 512, 576, 600};
  const AnalyzeHints hints{.threads = 2, .eliminated_blocks = 600, .elimination_bounds = bounds};
  Schur whole(structure, hints, true), stepwise(structure, hints, true);
  std::vector<double> expected(whole.reduced_structure().scalars()), actual(expected.size());
  const auto eliminate = [&] {
    return whole.eliminate(problem.linearizer.values(), problem.damping, {}, r.data(), expected.data());
  };
  ASSERT_EQ(eliminate().status, LinearStatus::kOk);
  ASSERT_GT(whole.slices(), 2);
  const std::size_t parts = bounds.size() - 1, slices = static_cast<std::size_t>(stepwise.slices());
  for (int round = 0; round < 2; ++round) {
    stepwise.begin(problem.damping, r.data());
    for (std::size_t s = slices; s-- > 0;) {  // slices may come in any order
      for (std::uint32_t e = bounds[parts * s / slices]; e < bounds[parts * (s + 1) / slices]; ++e)
        stepwise.eliminate_columns(static_cast<int>(s), e, e + 1,
                                   problem.linearizer.values().data() + problem.plan.first_value(e), {});
    }
    ASSERT_EQ(stepwise.finish(problem.linearizer.values(), actual.data()).status, LinearStatus::kOk);
    EXPECT_THAT(stepwise.reduced_values(), testing::ElementsAreArray(whole.reduced_values()));
    EXPECT_EQ(actual, expected);
  }
}

TEST(Schur, NamesTheSameBlockForAnyNumberOfThreads) {
  const Problem problem(make_bundle(12, 600, true), 0, false);
  std::vector<double> values(problem.linearizer.values().begin(), problem.linearizer.values().end());
  const BlockStructure& structure = problem.plan.structure;
  for (const std::uint32_t block : {400u, 99u})
    values[structure.value_start[structure.column_start[block]]] = -1;
  for (const int threads : {1, 2, 5}) {
    Schur schur(structure, problem.hints(threads), true);
    for (int round = 0; round < 2; ++round) {
      const FactorResult result = schur.eliminate(values, {});
      EXPECT_EQ(result.status, LinearStatus::kNotPositiveDefinite);
      EXPECT_EQ(result.failed_block, 99u);
    }
    EXPECT_EQ(schur.eliminate(problem.linearizer.values(), {}).status, LinearStatus::kOk);
  }
}

TEST(Schur, AcceptsEdgesOfSeveralTypesAtTheSamePoints) {
  Bundle bundle = make_bundle(3, 20, true);
  const auto size = bundle.graph.add_vertex(1.0);
  for (std::size_t k = 0; k < bundle.points.size(); ++k) {
    const auto& point = bundle.points[k];
    bundle.graph.add_edge([](const auto& p) { return (0.1 * p).eval(); }, point);
    if (k % 2 == 0) continue;
    bundle.graph.add_edge([](const auto& s, const auto& p) { return (s * p).eval(); }, size, point);
    bundle.graph.add_edge([](const auto& p, const auto& c, const auto& s) { return (c * p * s).eval(); },
                          point, bundle.cameras[k % 3], size);
  }
  Problem problem(std::move(bundle), 0.5, true);
  expect_equals_reference(problem.bundle.graph, problem.plan);
  check_elimination(problem);
}

TEST(Schur, ReportsThePointThatOnlyOneCameraSees) {
  Bundle bundle = make_bundle(3, 20, true);
  const auto lonely = bundle.graph.add_vertex(Eigen::Vector3d(1, 0.5, 8));
  bundle.graph.set_eliminated(lonely, true);
  bundle.graph.add_edge(Reprojection{10, 20}, bundle.cameras[1], lonely);
  Problem problem(std::move(bundle), 0, false);
  Schur schur(problem.plan.structure, problem.hints(), true);
  const FactorResult result = schur.eliminate(problem.linearizer.values(), problem.damping);
  EXPECT_EQ(result.status, LinearStatus::kNotPositiveDefinite);
  ASSERT_LT(result.failed_block, problem.plan.block_vertex.size());
  EXPECT_EQ(problem.plan.block_vertex[result.failed_block], VertexRef(lonely));
  EXPECT_EQ(schur.eliminate(problem.linearizer.values(), {1e-3, nullptr}).status, LinearStatus::kOk);
}

TEST(Schur, ReportsTheBlockThatIsNotFinite) {
  Problem problem(make_bundle(2, 5, true), 0, false);
  std::vector<double> values(problem.linearizer.values().begin(), problem.linearizer.values().end());
  values[problem.plan.structure.value_start[problem.plan.structure.column_start[3]]] = std::nan("");
  Schur schur(problem.plan.structure, problem.hints(), true);
  const FactorResult result = schur.eliminate(values, {});
  EXPECT_EQ(result.status, LinearStatus::kNotFinite);
  EXPECT_EQ(result.failed_block, 3u);
}

/// Cameras of the given dimensions see all points of the given dimensions. Successive cameras are connected,
/// and the first with the last.
TestSystem system_of(const std::vector<std::uint32_t>& points, const std::vector<std::uint32_t>& cameras) {
  std::mt19937 random(11);
  std::vector<std::uint32_t> dims = points;
  dims.insert(dims.end(), cameras.begin(), cameras.end());
  std::vector<BlockCoordinate> edges;
  for (std::uint32_t p = 0; p < points.size(); ++p) {
    for (auto c = static_cast<std::uint32_t>(points.size()); c < dims.size(); ++c) edges.push_back({c, p});
  }
  const auto first = static_cast<std::uint32_t>(points.size());
  const auto last = static_cast<std::uint32_t>(dims.size() - 1);
  for (std::uint32_t c = first + 1; c <= last; ++c) edges.push_back({c, c - 1});
  if (last > first + 1) edges.push_back({last, first});
  return random_system(dims, edges, random, 3);
}

TEST(Schur, EqualsTheDenseComplementForBlocksOfAllSizes) {
  const std::vector<std::vector<std::uint32_t>> cameras{
      {6, 6, 6}, {7, 7}, {9, 9, 9}, {3, 3}, {2, 2}, {6, 3, 6, 4, 6, 3}, {15, 6, 9, 1, 5}};
  for (const auto& kept_dims : cameras) {
    for (const std::uint32_t dim : {1u, 2u, 3u, 4u, 6u}) {
      SCOPED_TRACE(testing::PrintToString(kept_dims) + " points of " + std::to_string(dim));
      TestSystem system = system_of(std::vector<std::uint32_t>(8, dim), kept_dims);
      const double lambda = 0.25;
      const Eigen::MatrixXd H = system.dense();
      const Eigen::Index n = H.rows(), eliminated = 8 * dim, kept = n - eliminated;
      Eigen::MatrixXd damped = H;
      damped.diagonal().array() += lambda;
      const Eigen::MatrixXd W = H.bottomLeftCorner(kept, eliminated);
      const Eigen::MatrixXd S = H.bottomRightCorner(kept, kept) -
                                W * damped.topLeftCorner(eliminated, eliminated).llt().solve(W.transpose());
      const Eigen::VectorXd r = Eigen::VectorXd::LinSpaced(n, -1, 2), solved = damped.llt().solve(r);
      for (const KeptBlocks blocks : {KeptBlocks::kSeparate, KeptBlocks::kJoined}) {
        Schur schur(system.structure, {.eliminated_blocks = 8}, true, blocks);
        ASSERT_EQ(schur.eliminate(system.values, {lambda, nullptr}).status, LinearStatus::kOk);
        EXPECT_LE((dense_matrix(schur.reduced_structure(), schur.reduced_values()) - S).norm(),
                  1e-12 * H.norm());
        Eigen::VectorXd reduced_r(kept), y(kept), x(n);
        schur.multiply(r.tail(kept).eval().data(), y.data());
        EXPECT_LE((y - S * r.tail(kept)).norm(), 1e-12 * H.norm());
        schur.reduce(r.data(), reduced_r.data());
        const Eigen::VectorXd reduced_x = solved.tail(kept);
        EXPECT_LE((S * reduced_x + lambda * reduced_x - reduced_r).norm(), 1e-11 * H.norm());
        schur.back_substitute(r.data(), reduced_x.data(), x.data());
        EXPECT_LE((x - solved).norm(), 1e-10 * solved.norm());
      }
    }
  }
}

/// The sizes of the blocks of S, after joining.
std::vector<std::uint32_t> joined_dims(const BlockStructure& structure, const AnalyzeHints& hints) {
  const Schur schur(structure, hints, true, KeptBlocks::kJoined);
  std::vector<std::uint32_t> dims;
  for (std::uint32_t block = 0; block < schur.reduced_structure().blocks(); ++block)
    dims.push_back(schur.reduced_structure().dim(block));
  return dims;
}

TEST(Schur, JoinsConsecutiveBlocksThatAreCoupledWithTheSameEliminatedBlocks) {
  const std::vector<std::uint32_t> dims{3, 3, 3, 6, 4, 6, 4, 6, 5, 2};
  const std::vector<BlockCoordinate> edges{{3, 0}, {4, 0}, {3, 2}, {4, 2},           // a pose and its camera
                                           {5, 0}, {5, 1}, {6, 0}, {6, 1},           // another pair
                                           {7, 0}, {7, 2}, {8, 1}, {8, 2}, {9, 8}};  // no two alike
  const std::vector<std::uint32_t> expected{10, 10, 6, 5, 2};
  EXPECT_EQ(joined_dims(make_block_structure(dims, edges), {.eliminated_blocks = 3}), expected);
}

TEST(Schur, JoinsNoBlocksThatAreCoupledWithNoEliminatedBlock) {
  const std::vector<BlockCoordinate> edges{{1, 0}, {3, 2}};
  const std::vector<std::uint32_t> expected{6, 6, 3};
  EXPECT_EQ(joined_dims(make_block_structure({3, 6, 6, 3}, edges), {.eliminated_blocks = 1}), expected);
}

TEST(Schur, JoinsBlocksOnlyIfThereAreKernelsForTheResult) {
  const TestSystem system = system_of({3, 3}, {6, 9, 6, 9, 6});
  EXPECT_EQ(dense::kernels().elimination_kernels_for(15, 3), nullptr);
  const std::vector<std::uint32_t> expected{6, 9, 6, 9, 6};
  EXPECT_EQ(joined_dims(system.structure, {.eliminated_blocks = 2}), expected);
}

TEST(Schur, JoinsNoBlockToOneThatMustComeLast) {
  const TestSystem system = system_of({3, 3}, {6, 4, 2, 5});
  const std::vector<std::uint32_t> last{3}, expected{10, 7};
  EXPECT_EQ(joined_dims(system.structure, {.eliminated_blocks = 2, .last = last}), expected);
}

TEST(Schur, FindsTheBlockOfEachScalarOfAJoinedBlock) {
  const TestSystem system = system_of({3, 3}, {6, 4, 6, 2});
  const Schur schur(system.structure, {.eliminated_blocks = 2}, true, KeptBlocks::kJoined);
  EXPECT_EQ(schur.place_of(3).block, 0u);
  EXPECT_EQ(schur.place_of(3).first, 6u);
  for (const auto& [scalar, block] :
       std::vector<std::pair<std::uint32_t, std::uint32_t>>{{0, 2}, {5, 2}, {6, 3}, {9, 3}, {10, 4}, {16, 5}})
    EXPECT_EQ(schur.block_with(scalar), block) << scalar;
}

TEST(Schur, IsEmptyIfAllVerticesAreEliminated) {
  Bundle bundle = make_bundle(2, 20, true);
  for (const auto& camera : bundle.cameras) bundle.graph.fix(camera);
  Problem problem(std::move(bundle), 0, false);
  Schur schur(problem.plan.structure, problem.hints(), true);
  EXPECT_EQ(schur.reduced_structure().blocks(), 0u);
  EXPECT_EQ(schur.eliminate(problem.linearizer.values(), {}).status, LinearStatus::kOk);
  const Eigen::VectorXd r = Eigen::VectorXd::LinSpaced(60, 1, 3);
  Eigen::VectorXd x(60);
  schur.back_substitute(r.data(), nullptr, x.data());
  EXPECT_LE((problem.hessian * x - r).norm(), 1e-9 * r.norm());
}

TEST(Schur, IsTheHessianIfNoVertexIsEliminated) {
  Problem problem(make_bundle(3, 5, false), 0, false);
  ASSERT_EQ(problem.plan.eliminated_blocks, 0u);
  Schur schur(problem.plan.structure, {.eliminated_blocks = 0}, true);
  ASSERT_EQ(schur.eliminate(problem.linearizer.values(), {}).status, LinearStatus::kOk);
  EXPECT_EQ(dense_matrix(schur.reduced_structure(), schur.reduced_values()), problem.hessian);
}

}  // namespace
}  // namespace boxplus
