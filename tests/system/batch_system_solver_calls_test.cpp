// SPDX-License-Identifier: BSD-3-Clause
// A system calls its linear solver as boxplus/linear/linear_solver.h demands, for every storage of columns.
#include <gtest/gtest.h>

#include "system/bundle_system.h"

namespace boxplus {
namespace {

/// A block Cholesky that checks how it is called.
class WatchedSolver final : public LinearSolver {
 public:
  std::string_view name() const override { return solver_->name(); }
  Needs needs() const override { return solver_->needs(); }
  void analyze(const BlockStructure& structure, const AnalyzeHints& hints, const StopToken& stop) override {
    structure_ = &structure;
    copy_ = structure;
    is_factorized_ = false;
    solver_->analyze(structure, hints, stop);
  }
  FactorResult factorize(const BlockSystem& system, const Damping& damping,
                         const SolveControl& control) override {
    ++factorizations;
    EXPECT_NE(structure_, nullptr) << "expected analyze() before factorize()";
    EXPECT_EQ(&system.structure(), structure_);
    EXPECT_EQ(system.structure(), copy_);
    EXPECT_EQ(system.values().size(), copy_.nonzero_values());
    for (std::uint32_t i = 0; i < copy_.scalars(); ++i) EXPECT_GE(damping(i), 0);
    system_ = &system;
    values_.assign(system.values().begin(), system.values().end());
    announced_ = control.right_hand_side;
    right_hand_side_.clear();
    if (announced_ != nullptr) right_hand_side_.assign(announced_, announced_ + copy_.scalars());
    const FactorResult result = solver_->factorize(system, damping, control);
    is_factorized_ = result.status == LinearStatus::kOk;
    return result;
  }
  SolveResult solve(const double* b, int columns, double* x, const SolveControl& control) override {
    ++solutions;
    EXPECT_TRUE(is_factorized_) << "expected a successful factorize() before solve()";
    EXPECT_TRUE(
        std::equal(values_.begin(), values_.end(), system_->values().begin(), system_->values().end()))
        << "the values must not change until the last solve()";
    if (announced_ != nullptr) {
      ++announcements;
      EXPECT_EQ(b, announced_);
      EXPECT_TRUE(std::equal(right_hand_side_.begin(), right_hand_side_.end(), b));
      announced_ = nullptr;  // it belongs to one solve() only
    }
    return solver_->solve(b, columns, x, control);
  }

  int factorizations = 0, solutions = 0, announcements = 0;

 private:
  std::unique_ptr<LinearSolver> solver_ = make_linear_solver(LinearSolverKind::kBlockCholesky);
  const BlockStructure* structure_ = nullptr;
  const BlockSystem* system_ = nullptr;
  BlockStructure copy_;
  std::vector<double> values_, right_hand_side_;
  const double* announced_ = nullptr;
  bool is_factorized_ = false;
};

class SolverCalls : public BundleSystem {
 protected:
  /// Makes steps in several orders of calls, some of which are stopped.
  void make_steps(BatchSystem& by) {
    by.configure({}, timings_, StopToken(&stop_));
    std::vector<double> step = zeros();
    for (const StepDamping& announced : {kDamped, kUndamped}) {
      by.expect(announced);
      ASSERT_TRUE(by.linearize());
      for (const StepDamping& damping : {kDamped, kUndamped, kByIdentity, kDamped}) {
        ASSERT_EQ(by.solve(damping, step).status, LinearStatus::kOk);
        by.try_step(step);
        by.reject();
        by.curvature(step);
      }
      stop_ = true;
      EXPECT_EQ(by.solve(kDamped, step).status, LinearStatus::kStopped);
      stop_ = false;
      ASSERT_EQ(by.solve(kDamped, step).status, LinearStatus::kOk);
      by.try_step(step);
      by.accept();
    }
  }
};

TEST_P(SolverCalls, ObeyTheContract) {
  const auto solver = std::make_shared<WatchedSolver>();
  BatchSystem watched = make_system(graph_, columns(), threads(), solver);
  make_steps(watched);
  EXPECT_EQ(solver->solutions, 10);
  EXPECT_GE(solver->factorizations, 10);
}

TEST_P(SolverCalls, ObeyTheContractWithoutElimination) {
  for (const VertexRef& vertex : graph_.all_vertices()) graph_.set_eliminated(vertex, false);
  const auto solver = std::make_shared<WatchedSolver>();
  BatchSystem watched = make_system(graph_, columns(), threads(), solver);
  make_steps(watched);
  EXPECT_EQ(solver->solutions, 10 + 2 * 7);  // two undamped steps are shortened along seven free motions
  EXPECT_EQ(solver->announcements, 10);
}

INSTANTIATE_TEST_SUITE_P(Bundle, SolverCalls, every_storage(), name_of_storage);

}  // namespace
}  // namespace boxplus
