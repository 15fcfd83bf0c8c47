// SPDX-License-Identifier: BSD-3-Clause
#include "petsc_solver.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <span>
#include <utility>

#include "boxplus/base/error.h"
#include "boxplus/petsc/make_divided_petsc_solver.h"
#include "boxplus/petsc/make_petsc_solver.h"
#include "linear/finite_check.h"
#include "linear/lost_pivot.h"

namespace boxplus {

std::unique_ptr<LinearSolver> make_petsc_solver(const std::string& options) {
  return std::make_unique<petsc::Solver>(options);
}

std::unique_ptr<LinearSolver> make_divided_petsc_solver(MPI_Comm communicator, const std::string& options) {
  return std::make_unique<petsc::Solver>(options, communicator);
}

namespace petsc {
namespace {

/// A solution with xᵀr below this fraction of xᵀb has the curvature xᵀ(A + λD)x = bᵀx of an exact one.
constexpr double kExact = 1e-12;
/// A factor whose solutions leave a larger part of the right-hand side, even if they are refined, has no
/// correct digits.
constexpr double kUseless = 1e-3;
/// A round of corrections must reduce the residual to this fraction of itself. Otherwise, it was the last.
constexpr double kProgress = 0.5;

/// Whether the preconditioner is A⁻¹, except for rounding.
bool factorizes(const Calls& calls, PC pc) {
  return is_type(calls, pc, PCCHOLESKY) || is_type(calls, pc, PCLU);
}

/// MUMPS, if PETSc was built with it.
std::string package_for_cholesky(const Calls& calls) {
  PetscBool has_package = PETSC_FALSE, can_factorize = PETSC_FALSE;
  calls(MatInitializePackage());  // before, the table of packages is empty
  calls(MatSolverTypeGet(MATSOLVERMUMPS, MATSEQAIJ, MAT_FACTOR_CHOLESKY, &has_package, &can_factorize,
                         nullptr));
  return can_factorize ? MATSOLVERMUMPS : MATSOLVERPETSC;
}

/// Copies a vector of PETSc.
void copy(const Calls& calls, Vec from, double* to) {
  const PetscScalar* values = nullptr;
  PetscInt size = 0;
  calls(VecGetLocalSize(from, &size));
  calls(VecGetArrayRead(from, &values));
  std::copy_n(values, size, to);
  calls(VecRestoreArrayRead(from, &values));
}

void copy(const Calls& calls, const double* from, Vec to) {
  PetscScalar* values = nullptr;
  PetscInt size = 0;
  calls(VecGetLocalSize(to, &size));
  calls(VecGetArrayWrite(to, &values));
  std::copy_n(from, size, values);
  calls(VecRestoreArrayWrite(to, &values));
}

double dot(const Calls& calls, Vec a, Vec b) {
  PetscScalar result = 0;
  calls(VecDot(a, b, &result));
  return result;
}

double norm(const Calls& calls, Vec a) {
  PetscReal result = 0;
  calls(VecNorm(a, NORM_2, &result));
  return result;
}

LinearStatus status_of(KSPConvergedReason reason) {
  switch (reason) {
    case KSP_DIVERGED_INDEFINITE_MAT:
    case KSP_DIVERGED_INDEFINITE_PC:
    case KSP_DIVERGED_PC_FAILED:
      return LinearStatus::kNotPositiveDefinite;
    default:
      return reason < 0 ? LinearStatus::kNotConverged : LinearStatus::kOk;
  }
}

}  // namespace

Solver::Solver(const std::string& options) : Solver(options, PETSC_COMM_SELF, false) {}

Solver::Solver(const std::string& options, MPI_Comm communicator) : Solver(options, communicator, true) {}

Solver::Solver(const std::string& options, MPI_Comm communicator, bool is_divided)
    : communicator_(communicator),
      is_divided_(is_divided),
      texts_(parse_options(options)),
      options_(make_options(options)),
      has_own_tolerance_(texts_.contains("-ksp_rtol")),
      has_own_limit_(texts_.contains("-ksp_max_it")) {
  if (texts_.contains("-mat_block_size"))
    throw InvalidArgument("PETSc: expected options without -mat_block_size, which the graph decides");
  if (std::isnan(std::strtod(option("-ksp_rtol").c_str(), nullptr)))
    throw InvalidArgument("PETSc: expected a number after -ksp_rtol, got '" + option("-ksp_rtol") + "'");
}

/// The value of an option, or `absent`.
std::string Solver::option(const char* name, const std::string& absent) const {
  const auto found = texts_.find(name);
  return found == texts_.end() ? absent : found->second;
}

Solver::~Solver() {
  if (!is_running()) return;
  {
    const Calls calls(options_);
    problem_.reset();
  }
  const Calls calls(nullptr);
  options_.reset();
}

/// Sets the defaults for what the options leave open, and then the options.
void Solver::choose_methods(const Calls& calls) {
  const std::string method = option("-ksp_type"), preconditioner = option("-pc_type");
  const bool is_direct = method == KSPPREONLY || (method.empty() && preconditioner.empty());
  const std::string type = !preconditioner.empty() ? preconditioner : is_direct ? PCCHOLESKY : PCPBJACOBI;
  const std::string package = option("-pc_factor_mat_solver_type", package_for_cholesky(calls));
  // MUMPS needs the symmetric format. The factorization of PETSc counts its negative pivots only in AIJ.
  const MatType format = type != PCCHOLESKY ? MATBAIJ : package == MATSOLVERMUMPS ? MATSBAIJ : MATAIJ;
  problem_.emplace(calls, *structure_, *layout_, format);
  const Matrix& matrix = problem_->matrix;
  calls(KSPCreate(communicator_, problem_->ksp.out()));
  const KSP ksp = problem_->ksp;
  calls(KSPSetOperators(ksp, matrix, matrix));
  calls(KSPSetType(ksp, is_direct ? KSPPREONLY : KSPCG));
  // No residual is small in absolute terms, or too large.
  calls(KSPSetTolerances(ksp, PETSC_DEFAULT, 0, std::numeric_limits<double>::max(), PETSC_DEFAULT));
  calls(KSPGetPC(ksp, &problem_->pc));
  if (type == PCCHOLESKY) {
    calls(PCSetType(problem_->pc, PCCHOLESKY));
    calls(PCFactorSetMatSolverType(problem_->pc, package.c_str()));
  } else if (preconditioner.empty()) {
    calls(PCSetType(problem_->pc, layout_->block_size() > 0 ? PCPBJACOBI : PCVPBJACOBI));
  }
  calls(KSPSetFromOptions(ksp));
  is_direct_ = is_type(calls, ksp, KSPPREONLY) && factorizes(calls, problem_->pc);
  if (is_type(calls, ksp, KSPCG) && !texts_.contains("-ksp_norm_type"))
    calls(KSPSetNormType(ksp, KSP_NORM_UNPRECONDITIONED));
  if (!is_type(calls, ksp, KSPPREONLY)) watch_stop(calls);
}

void Solver::watch_stop(const Calls& calls) {
  watch_ = std::make_unique<Watch>();
  calls(KSPGetAndClearConvergenceTest(problem_->ksp, &watch_->test, &watch_->context, &watch_->destroy));
  const auto test = [](KSP ksp, PetscInt iteration, PetscReal residual, KSPConvergedReason* reason,
                       void* context) -> PetscErrorCode {
    auto& watch = *static_cast<Watch*>(context);
    if (!watch.stop.raised()) return watch.test(ksp, iteration, residual, reason, watch.context);
    watch.stopped = true;
    *reason = KSP_DIVERGED_ITS;
    return 0;
  };
  const auto destroy = [](void* context) -> PetscErrorCode {
    auto& watch = *static_cast<Watch*>(context);
    return watch.destroy != nullptr ? watch.destroy(watch.context) : 0;
  };
  calls(KSPSetConvergenceTest(problem_->ksp, test, watch_.get(), destroy));
}

void Solver::make_vectors(const Calls& calls) {
  Problem& p = *problem_;
  for (Vector* vector : {&p.right_hand_side, &p.correction, &p.solution, &p.residual})
    calls(MatCreateVecs(p.matrix, vector->out(), nullptr));
  if (!is_divided_) return;
  const std::vector<PetscInt> scalars = layout_->scalars_of_blocks();
  const auto count = static_cast<PetscInt>(scalars.size());
  Owned<IS, ISDestroy> places;
  calls(ISCreateGeneral(PETSC_COMM_SELF, count, scalars.data(), PETSC_COPY_VALUES, places.out()));
  calls(VecCreateSeq(PETSC_COMM_SELF, count, p.here.out()));
  calls(VecScatterCreate(p.solution, places, p.here, nullptr, p.way.out()));
}

/// Makes b, or the sum of what processes contribute to it, the right-hand side.
void Solver::load(const Calls& calls, const double* b) {
  Problem& p = *problem_;
  if (!is_divided_) return copy(calls, b, p.right_hand_side);
  copy(calls, b, p.here);
  calls(VecZeroEntries(p.right_hand_side));
  calls(VecScatterBegin(p.way, p.here, p.right_hand_side, ADD_VALUES, SCATTER_REVERSE));
  calls(VecScatterEnd(p.way, p.here, p.right_hand_side, ADD_VALUES, SCATTER_REVERSE));
}

/// Copies the scalars of the solution that belong to this process.
void Solver::store(const Calls& calls, double* x) {
  Problem& p = *problem_;
  if (!is_divided_) return copy(calls, p.solution, x);
  calls(VecScatterBegin(p.way, p.solution, p.here, INSERT_VALUES, SCATTER_FORWARD));
  calls(VecScatterEnd(p.way, p.solution, p.here, INSERT_VALUES, SCATTER_FORWARD));
  copy(calls, p.here, x);
}

void Solver::analyze(const BlockStructure& structure, const AnalyzeHints& hints, const StopToken& stop) {
  stop.check();
  if (is_divided_ != (hints.divided != nullptr))
    throw InvalidArgument(is_divided_
                              ? "PETSc: expected a DistributedOptimizer for a solver that divides systems"
                              : "PETSc: expected a solver that divides systems");
  const Calls calls(options_);
  factorized_ = false;
  statistics_ = {};
  problem_.reset();
  watch_.reset();
  structure_ = &structure;
  may_be_singular_ = hints.may_be_singular;
  last_.assign(hints.last.begin(), hints.last.end());
  layout_.emplace(structure, hints.divided, communicator_);
  try {
    make_problem(calls);
  } catch (...) {
    problem_.reset();
    structure_ = nullptr;
    throw;
  }
}

void Solver::make_problem(const Calls& calls) {
  has_failed_ = false;
  problem_.reset();
  watch_.reset();
  if (layout_->scalars() == 0) return;
  choose_methods(calls);
  make_vectors(calls);
}

FactorResult Solver::factorize(const BlockSystem& system, const Damping& damping,
                               const SolveControl& control) {
  factorized_ = false;
  if (structure_ == nullptr)
    throw InvalidArgument("petsc::Solver::factorize: expected an earlier call of analyze()");
  const BlockStructure& s = *structure_;
  const std::span<const double> values = system.values();
  if (values.size() != s.nonzero_values())
    throw InvalidArgument("petsc::Solver::factorize: expected the block values of the analyzed structure");
  if (control.stop.raised()) return {LinearStatus::kStopped};
  const Calls calls(options_);
  const std::uint32_t not_finite = find_not_finite(s, values.data(), damping);
  if (layout_->any(calls, not_finite != BlockStructure::kAbsent))
    return {LinearStatus::kNotFinite, not_finite};
  if (has_failed_) make_problem(calls);  // MUMPS would not factorize again
  if (problem_) {
    problem_->matrix.assign(calls, values.data(), damping);
    if (const FactorResult result = check_diagonal(calls); result.status != LinearStatus::kOk) return result;
    has_failed_ = true;  // until this function ends without an exception
    // Otherwise, PETSc would notice the new values only in KSPSolve().
    calls(KSPSetOperators(problem_->ksp, problem_->matrix, problem_->matrix));
    calls(KSPSetUp(problem_->ksp));
    calls(KSPSetUpOnBlocks(problem_->ksp));
    FactorResult result = setup_failure(calls);
    has_failed_ = result.status != LinearStatus::kOk;
    if (result.status == LinearStatus::kOk && is_direct_ && may_be_singular_) result = find_lost_pivot(calls);
    if (control.stop.raised()) return {LinearStatus::kStopped};
    if (result.status != LinearStatus::kOk) return result;
    collect_statistics(calls);
  }
  factorized_ = true;
  return {};
}

/// Iterative methods might not notice an entry ≤ 0.
FactorResult Solver::check_diagonal(const Calls& calls) {
  PetscInt scalar = 0;
  PetscReal least = 0;
  calls(MatGetDiagonal(problem_->matrix, problem_->residual));
  calls(VecMin(problem_->residual, &scalar, &least));
  if (least > 0) return {};
  const std::uint32_t block = layout_->find_block(scalar);
  if (block == BlockStructure::kAbsent) return {LinearStatus::kNotPositiveDefinite};
  const PetscInt in_block = scalar - layout_->first_scalar(layout_->number(block));
  return {LinearStatus::kNotPositiveDefinite, block,
          structure_->offset[block] + static_cast<std::uint32_t>(in_block)};
}

FactorResult Solver::setup_failure(const Calls& calls) {
  PCFailedReason reason = PC_NOERROR;
  calls(PCGetFailedReason(problem_->pc, &reason));
  if (reason == PC_FACTOR_OUTMEMORY)
    throw Error("PETSc: the factorization needs more memory (for MUMPS, see -mat_mumps_icntl_14)");
  if (reason == PC_FACTOR_OTHER) {
    const std::optional<PetscInt> code = is_direct_ ? infog_of_mumps(calls, 1) : std::nullopt;
    throw Error("PETSc: the factorization failed" +
                (code ? " (INFOG(1) of MUMPS is " + std::to_string(*code) + ")" : std::string()));
  }
  if (reason != PC_NOERROR || (is_direct_ && has_negative_pivot(calls)))
    return {LinearStatus::kNotPositiveDefinite};
  return {};
}

/// INFOG(index) of MUMPS; nullopt if another library factorizes.
std::optional<PetscInt> Solver::infog_of_mumps(const Calls& calls, PetscInt index) const {
  Mat factor = nullptr;
  MatSolverType package = nullptr;
  calls(PCFactorGetMatrix(problem_->pc, &factor));
  calls(MatFactorGetSolverType(factor, &package));
  if (package == nullptr || std::string(package) != MATSOLVERMUMPS) return std::nullopt;
  PetscInt value = 0;
  calls(MatMumpsGetInfog(factor, index, &value));
  return value;
}

/// Whether the factor has a negative pivot. (Some factorizations of PETSc do not say.)
bool Solver::has_negative_pivot(const Calls& calls) const {
  if (const std::optional<PetscInt> negative = infog_of_mumps(calls, 12)) return *negative > 0;
  Mat factor = nullptr;
  calls(PCFactorGetMatrix(problem_->pc, &factor));
  PetscInt negative = 0, zero = 0, positive = 0;
  const PetscErrorCode code = MatGetInertia(factor, &negative, &zero, &positive);
  if (code == PETSC_ERR_SUP) return false;
  calls(code);
  return negative > 0;
}

/// Searches the blocks that should come last for a pivot without correct digits. If scalar j comes last, its
/// pivot is 1 / xⱼ with (A + λD) x = eⱼ, and lost_pivot.h compares it with the diagonal along x / xⱼ. If
/// several are lost, the result names the one that takes the largest part in the motion that is free.
FactorResult Solver::find_lost_pivot(const Calls& calls) {
  const BlockStructure& s = *structure_;
  diagonal_.resize(s.scalars());
  calls(MatGetDiagonal(problem_->matrix, problem_->residual));
  copy(calls, problem_->residual, diagonal_.data());
  FactorResult worst;
  double largest_part = 0;
  std::vector<double> x(s.scalars());
  for (const std::uint32_t block : last_) {
    for (std::uint32_t j = s.offset[block]; j < s.offset[block + 1]; ++j) {
      calls(VecZeroEntries(problem_->right_hand_side));
      calls(VecSetValue(problem_->right_hand_side, static_cast<PetscInt>(j), 1, INSERT_VALUES));
      calls(VecAssemblyBegin(problem_->right_hand_side));
      calls(VecAssemblyEnd(problem_->right_hand_side));
      calls(KSPSolve(problem_->ksp, problem_->right_hand_side, problem_->solution));
      copy(calls, problem_->solution, x.data());
      double along = 0;
      for (std::uint32_t i = 0; i < s.scalars(); ++i) along += x[i] * x[i] * diagonal_[i];
      // 1 / xⱼ > kLostPivot · along / xⱼ²
      if (x[j] > 0 && x[j] > kLostPivot * along) continue;
      const double part = x[j] * x[j] * diagonal_[j] / along;
      if (worst.status == LinearStatus::kOk || part > largest_part)
        worst = {LinearStatus::kNotPositiveDefinite, block, j};
      largest_part = std::max(largest_part, part);
    }
  }
  return worst;
}

void Solver::collect_statistics(const Calls& calls) {
  if (!is_direct_ || statistics_.factor_nonzeros > 0) return;
  Mat factor = nullptr;
  calls(PCFactorGetMatrix(problem_->pc, &factor));
  MatInfo info;
  calls(MatGetInfo(factor, MAT_GLOBAL_SUM, &info));
  statistics_.factor_nonzeros = static_cast<std::uint64_t>(std::max(0.0, info.nz_used));
}

SolveResult Solver::solve(const double* b, int columns, double* x, const SolveControl& control) {
  if (!factorized_) throw InvalidArgument("petsc::Solver::solve: expected an earlier successful factorize()");
  const std::size_t size = structure_->scalars();
  const Calls calls(options_);
  if (layout_->any(calls, !all_finite(b, size * static_cast<std::size_t>(std::max(0, columns)))))
    return {LinearStatus::kNotFinite};
  SolveResult total{.exact = true};
  for (int c = 0; c < columns && problem_; ++c, b += size, x += size) {
    const SolveResult result = solve_column(calls, b, x, control);
    total.iterations += result.iterations;
    total.exact = total.exact && result.exact;
    total.status = result.status;
    if (!options_are_checked_) refuse_unused_options(calls);
    if (result.status != LinearStatus::kOk) break;
  }
  total.exact = total.exact && total.status == LinearStatus::kOk;
  return total;
}

/// Adds corrections to x = 0 until the residual is small enough, or a correction does not help.
SolveResult Solver::solve_column(const Calls& calls, const double* b, double* x,
                                 const SolveControl& control) {
  Problem& p = *problem_;
  if (control.stop.raised()) return {LinearStatus::kStopped};
  if (watch_) {
    watch_->stop = control.stop;
    watch_->stopped = false;
  }
  const int limit = control.max_iterations > 0 ? control.max_iterations
                                               : std::max(100, 2 * std::min(layout_->scalars(), 1 << 29));
  load(calls, b);
  calls(VecCopy(p.right_hand_side, p.residual));
  calls(VecZeroEntries(p.solution));
  const double size = norm(calls, p.right_hand_side), target = control.relative_tolerance * size;
  double left = size;
  SolveResult result;
  for (int round = 0; left > target || round == 0; ++round) {
    int iterations = 0;
    const double tolerance = left > 0 ? std::min(kProgress, target / left) : kProgress;
    result.status = correct(calls, tolerance, limit - result.iterations, iterations);
    result.iterations += is_direct_ ? (round > 0 ? 1 : 0) : iterations;
    calls(VecAXPY(p.solution, 1, p.correction));
    calls(MatMult(p.matrix, p.solution, p.residual));
    calls(VecAYPX(p.residual, -1, p.right_hand_side));
    const double before = std::exchange(left, norm(calls, p.residual));
    const bool helps = left <= kProgress * before;
    if (result.status != LinearStatus::kOk || has_own_tolerance_ || !helps || result.iterations >= limit)
      break;
    if (control.stop.raised()) return {LinearStatus::kStopped, result.iterations};
  }
  if (watch_ && watch_->stopped) return {LinearStatus::kStopped, result.iterations};
  store(calls, x);
  const double slope = dot(calls, p.right_hand_side, p.solution);
  const double rest = dot(calls, p.residual, p.solution);
  // xᵀ(A + λD)x = slope − rest
  const bool is_lost = !std::isfinite(left) || (is_direct_ && left > kUseless * size) || slope < rest;
  if (is_lost && result.status == LinearStatus::kOk) result.status = LinearStatus::kNotPositiveDefinite;
  if (result.status == LinearStatus::kOk && !is_direct_ && !has_own_tolerance_ && left > target)
    result.status = LinearStatus::kNotConverged;
  result.exact = is_direct_ && std::abs(rest) <= kExact * slope;
  return result;
}

/// Solves for the correction of the residual.
LinearStatus Solver::correct(const Calls& calls, double tolerance, int iterations_left, int& iterations) {
  const KSP ksp = problem_->ksp;
  // PETSC_DEFAULT leaves a value as it is.
  calls(KSPSetTolerances(ksp, has_own_tolerance_ ? PETSC_DEFAULT : tolerance, PETSC_DEFAULT, PETSC_DEFAULT,
                         has_own_limit_ ? PETSC_DEFAULT : iterations_left));
  calls(KSPSolve(ksp, problem_->residual, problem_->correction));
  PetscInt count = 0;
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  calls(KSPGetIterationNumber(ksp, &count));
  calls(KSPGetConvergedReason(ksp, &reason));
  iterations = static_cast<int>(count);
  return status_of(reason);
}

void Solver::refuse_unused_options(const Calls& calls) {
  PetscInt count = 0;
  char **names = nullptr, **values = nullptr;
  calls(PetscOptionsLeftGet(options_, &count, &names, &values));
  const std::string first = count > 0 ? names[0] : "";
  calls(PetscOptionsLeftRestore(options_, &count, &names, &values));
  if (!first.empty()) throw InvalidArgument("PETSc: no method that is in use has the option -" + first);
  options_are_checked_ = true;
}

}  // namespace petsc
}  // namespace boxplus
