// SPDX-License-Identifier: BSD-3-Clause
// The LinearSolver that make_petsc_solver() makes.
#pragma once

#include <petscksp.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "boxplus/linear/linear_solver.h"
#include "petsc_matrix.h"

namespace boxplus::petsc {

class Solver final : public LinearSolver {
 public:
  /// Solves in this process.
  explicit Solver(const std::string& options);
  /// Solves systems that the processes of a communicator share.
  Solver(const std::string& options, MPI_Comm communicator);
  ~Solver() override;
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;

  std::string_view name() const override { return "petsc"; }
  Needs needs() const override { return is_divided_ ? Needs::kContributions : Needs::kBlocks; }
  void analyze(const BlockStructure& structure, const AnalyzeHints& hints, const StopToken& stop) override;
  FactorResult factorize(const BlockSystem& system, const Damping& damping,
                         const SolveControl& control) override;
  SolveResult solve(const double* b, int columns, double* x, const SolveControl& control) override;
  LinearStatistics statistics() const override { return statistics_; }

 private:
  using Vector = Owned<Vec, VecDestroy>;
  /// What belongs to one structure. Members are destroyed in reverse order.
  struct Problem {
    Problem(const Calls& calls, const BlockStructure& structure, const Layout& layout, MatType type)
        : matrix(calls, structure, layout, type) {}
    Matrix matrix;
    Owned<KSP, KSPDestroy> ksp;
    PC pc = nullptr;  // of ksp
    Vector right_hand_side, correction, solution, residual;
    Vector here;                               // the scalars of the blocks of this process
    Owned<VecScatter, VecScatterDestroy> way;  // from vectors of all scalars to `here`
  };
  /// A convergence test of PETSc, which also ends a solution if the token is raised.
  struct Watch {
    PetscErrorCode (*test)(KSP, PetscInt, PetscReal, KSPConvergedReason*, void*) = nullptr;
    PetscErrorCode (*destroy)(void*) = nullptr;
    void* context = nullptr;
    StopToken stop;
    bool stopped = false;
  };

  void make_problem(const Calls& calls);
  void choose_methods(const Calls& calls);
  void make_vectors(const Calls& calls);
  void watch_stop(const Calls& calls);
  void load(const Calls& calls, const double* b);
  void store(const Calls& calls, double* x);
  FactorResult check_diagonal(const Calls& calls);
  FactorResult setup_failure(const Calls& calls);
  std::optional<PetscInt> infog_of_mumps(const Calls& calls, PetscInt index) const;
  FactorResult find_lost_pivot(const Calls& calls);
  void collect_statistics(const Calls& calls);
  SolveResult solve_column(const Calls& calls, const double* b, double* x, const SolveControl& control);
  LinearStatus correct(const Calls& calls, double tolerance, int iterations_left, int& iterations);
  void refuse_unused_options(const Calls& calls);
  bool has_negative_pivot(const Calls& calls) const;

  std::string option(const char* name, const std::string& absent = {}) const;

  Solver(const std::string& options, MPI_Comm communicator, bool is_divided);

  MPI_Comm communicator_;
  bool is_divided_;
  std::map<std::string, std::string> texts_;
  Options options_;
  bool is_direct_ = false;          // preonly with a factorization
  bool has_own_tolerance_ = false;  // -ksp_rtol
  bool has_own_limit_ = false;      // -ksp_max_it
  const BlockStructure* structure_ = nullptr;
  bool may_be_singular_ = false;
  std::vector<std::uint32_t> last_;
  std::optional<Layout> layout_;
  std::optional<Problem> problem_;
  std::unique_ptr<Watch> watch_;
  std::vector<double> diagonal_;  // of A + λD
  bool factorized_ = false, has_failed_ = false, options_are_checked_ = false;
  LinearStatistics statistics_;
};

}  // namespace boxplus::petsc
