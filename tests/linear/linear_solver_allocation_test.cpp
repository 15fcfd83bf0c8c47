// SPDX-License-Identifier: BSD-3-Clause
// factorize() and solve() allocate nothing after their first call.
#include <gtest/gtest.h>

#include "allocation_counter.h"
#include "linear/every_solver.h"
#include "linear/test_system.h"

namespace boxplus {
namespace {

class LinearSolverAllocations : public ::testing::TestWithParam<std::tuple<LinearSolverKind, bool>> {};

TEST_P(LinearSolverAllocations, HappenOnlyInTheFirstFactorizationAndSolve) {
  if (!testing::allocations_are_counted()) GTEST_SKIP() << "a sanitizer has its own allocator";
  std::mt19937 random(1);
  TestSystem system = random_system(std::vector<std::uint32_t>(225, 6), grid_edges(15, 15), random);
  const AssembledSystem view = system.view();
  const auto& [kind, eliminates] = GetParam();
  std::shared_ptr<LinearSolver> solver = make_linear_solver(kind);
  if (eliminates) solver = make_schur_solver(std::move(solver));
  solver->analyze(system.structure, {.right_hand_sides = 2, .threads = 2, .eliminated_blocks = 1});
  std::vector<double> b(2 * system.structure.scalars(), 1.0), x(b.size());
  bool good = true;
  const auto step = [&](double lambda, int columns) {
    good = solver->factorize(view, {.lambda = lambda}).status == LinearStatus::kOk &&
           solver->solve(b.data(), columns, x.data()).status == LinearStatus::kOk && good;
  };
  step(0, 1);
  const long before = testing::allocation_count();
  step(1, 1);
  step(2, 2);
  step(0, 2);
  const long after = testing::allocation_count();
  EXPECT_TRUE(good);
  EXPECT_EQ(after - before, 0);
}

std::string name_of(const std::tuple<LinearSolverKind, bool>& candidate) {
  return (std::get<bool>(candidate) ? "schur_" : "") +
         std::string(to_string(std::get<LinearSolverKind>(candidate)));
}

std::vector<LinearSolverKind> kinds() {
  std::vector<LinearSolverKind> all;
  for (const detail::LinearSolverEntry& entry : every_solver()) {
    if (!entry.allocates_in_every_call) all.push_back(entry.kind);
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(All, LinearSolverAllocations,
                         ::testing::Combine(::testing::ValuesIn(kinds()), ::testing::Bool()),
                         [](const auto& test) { return name_of(test.param); });

}  // namespace
}  // namespace boxplus
