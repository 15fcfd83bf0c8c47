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

}  // namespace
}  // namespace boxplus
