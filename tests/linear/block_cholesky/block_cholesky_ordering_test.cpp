// SPDX-License-Identifier: BSD-3-Clause
// The orderings of BlockCholeskyOptions.
#include <gtest/gtest.h>

#include "boxplus/linear/make_linear_solver.h"
#include "linear/block_cholesky/symbolic_factor.h"
#include "linear/test_system.h"

namespace boxplus {
namespace {

using Eigen::MatrixXd;

TEST(Ordering, DoesNotChangeTheSolution) {
  const TestSystem system = random_system(400, 900, 6);
  const AssembledSystem view(system.structure, system.values);
  MatrixXd x[2];
  for (const Ordering ordering : {Ordering::kMinimumDegree, Ordering::kNestedDissection}) {
    const auto solver =
        make_linear_solver(LinearSolverKind::kBlockCholesky, {.block_cholesky = {.ordering = ordering}});
    solver->analyze(system.structure, {});
    EXPECT_EQ(solver->statistics().ordering, ordering);
    MatrixXd& solution = x[ordering == Ordering::kNestedDissection];
    solution = MatrixXd::Ones(system.structure.scalars(), 1);
    ASSERT_EQ(solver->factorize(view, {}).status, LinearStatus::kOk);
    solver->solve(solution.data(), 1, solution.data());
  }
  EXPECT_LE((x[0] - x[1]).norm(), 1e-9 * x[0].norm());
}

TEST(AutomaticOrdering, IsNestedDissectionForALargeCubeAndMinimumDegreeForASmallCubeOrAPlanarGrid) {
  const auto taken = [](const BlockStructure& structure) {
    return outline_factor(structure, {}, {}, Ordering::kAutomatic).ordering;
  };
  EXPECT_EQ(taken(cube(14, 6)), Ordering::kNestedDissection);
  EXPECT_EQ(taken(cube(4, 6)), Ordering::kMinimumDegree);
  EXPECT_EQ(taken(make_block_structure(std::vector<std::uint32_t>(900, 3), grid_edges(30, 30))),
            Ordering::kMinimumDegree);
}

/// Every block is joined with every other block, except that blocks with different remainders of their number
/// by 3 are joined only if one remainder is 2.
std::vector<BlockCoordinate> two_overlapping_cliques(std::uint32_t blocks) {
  std::vector<BlockCoordinate> pairs;
  for (std::uint32_t a = 0; a < blocks; ++a) {
    for (std::uint32_t b = 0; b < a; ++b) {
      if (a % 3 == b % 3 || a % 3 == 2 || b % 3 == 2) pairs.push_back({a, b});
    }
  }
  return pairs;
}

std::vector<BlockCoordinate> all_pairs(std::uint32_t blocks) {
  std::vector<BlockCoordinate> pairs;
  for (std::uint32_t a = 0; a < blocks; ++a) {
    for (std::uint32_t b = 0; b < a; ++b) pairs.push_back({a, b});
  }
  return pairs;
}

TEST(AutomaticOrdering, IsNotNestedDissectionForACompleteGraph) {
  const std::vector<std::uint32_t> dims(700, 9);
  EXPECT_EQ(outline_factor(make_block_structure(dims, all_pairs(700)), {}, {}, Ordering::kAutomatic).ordering,
            Ordering::kMinimumDegree);
}

TEST(AutomaticOrdering, SeparatesTheCliquesOfADenseMatrixWhoseRowsAreAllDense) {
  const std::vector<std::uint32_t> dims(600, 9);
  const BlockStructure structure = make_block_structure(dims, two_overlapping_cliques(600));
  // Two cliques with 3600 scalars each, which share 1800.
  const auto cubed = [](double scalars) { return scalars * scalars * scalars / 3; };
  const double least = 2 * (cubed(3600) - cubed(1800)) + cubed(1800);
  for (const Ordering ordering : {Ordering::kMinimumDegree, Ordering::kAutomatic})
    EXPECT_NEAR(outline_factor(structure, {}, {}, ordering).flops / least, 1, 0.01);
}

}  // namespace
}  // namespace boxplus
