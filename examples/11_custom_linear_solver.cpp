// SPDX-License-Identifier: BSD-3-Clause
// A custom linear solver: implements the interface in boxplus/linear/linear_solver.h with Eigen's dense
// Cholesky factorization.
//
// This solver copies the blocks of A into a dense matrix, adds the damping λD to the diagonal, and solves the
// system.
#include <boxplus/linear/make_linear_solver.h>

#include <Eigen/Cholesky>
#include <cstdio>

using namespace boxplus;

// [solver]
class EigenLlt final : public LinearSolver {
 public:
  std::string_view name() const override { return "eigen_llt"; }
  Needs needs() const override { return Needs::kBlocks; }

  /// Called once per structure. Does all work that does not depend on the values of A, and allocates memory.
  void analyze(const BlockStructure& structure, const AnalyzeHints& /*hints*/,
               const StopToken& /*stop*/) override {
    structure_ = &structure;
    matrix_.resize(structure.scalars(), structure.scalars());
  }

  /// Called once for each linearization and each damping.
  FactorResult factorize(const BlockSystem& system, const Damping& damping,
                         const SolveControl& /*control*/) override {
    const BlockStructure& s = *structure_;
    matrix_.setZero();
    for (std::uint32_t j = 0; j < s.blocks(); ++j) {
      for (std::uint32_t k = s.column_start[j]; k < s.column_start[j + 1]; ++k) {
        const double* block = system.values().data() + s.value_start[k];
        matrix_.block(s.offset[s.row[k]], s.offset[j], s.dim(s.row[k]), s.dim(j)) =
            Eigen::Map<const Eigen::MatrixXd>(block, s.dim(s.row[k]), s.dim(j));
      }
    }
    for (std::uint32_t i = 0; i < s.scalars(); ++i) matrix_(i, i) += damping(i);
    cholesky_.compute(matrix_);  // reads only the lower triangle
    if (cholesky_.info() == Eigen::Success) return {};
    return {LinearStatus::kNotPositiveDefinite, 0};
  }

  /// Called any number of times per factorization; b and x may be the same array.
  SolveResult solve(const double* b, int columns, double* x, const SolveControl& /*control*/) override {
    const Eigen::Map<const Eigen::MatrixXd> right(b, matrix_.rows(), columns);
    Eigen::Map<Eigen::MatrixXd>(x, matrix_.rows(), columns) = cholesky_.solve(right).eval();
    return {.exact = true};
  }

 private:
  const BlockStructure* structure_ = nullptr;
  Eigen::MatrixXd matrix_;
  Eigen::LLT<Eigen::MatrixXd> cholesky_;
};
// [/solver]

int main() {
  // A has two coupled blocks of unknowns, with 2 and 1 scalars. Each block of A is stored column by column,
  // and diagonal blocks are stored in full.
  const BlockStructure structure = make_block_structure({2, 1}, {{1, 0}});
  const std::vector<double> values{4, 1, 1, 3, /* (1, 0) */ 1, 0.5, /* (1, 1) */ 2};
  const std::vector<double> b{1, 2, 3};
  const AssembledSystem system(structure, values);

  EigenLlt mine;
  const auto theirs = make_linear_solver(LinearSolverKind::kBlockCholesky);
  double x[2][3];
  int k = 0;
  for (LinearSolver* solver : {static_cast<LinearSolver*>(&mine), theirs.get()}) {
    solver->analyze(structure, {});
    if (solver->factorize(system, Damping{0.1}).status != LinearStatus::kOk) return 1;
    solver->solve(b.data(), 1, x[k]);
    std::printf("%-14s %.6f %.6f %.6f\n", solver->name().data(), x[k][0], x[k][1], x[k][2]);
    ++k;
  }
  return (Eigen::Vector3d(x[0]) - Eigen::Vector3d(x[1])).norm() < 1e-12 ? 0 : 1;
}
