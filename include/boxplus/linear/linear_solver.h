// SPDX-License-Identifier: BSD-3-Clause
// The seam between the optimiser and whatever solves (A + λ D) x = b.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "boxplus/base/stop_token.h"
#include "boxplus/linear/block_system.h"

namespace boxplus {

/// λ D, added to A inside the solver. D is the identity where `diagonal` is null, else diag(diagonal),
/// one number ≥ 0 per scalar of the system.
struct Damping {
  double lambda = 0;
  const double* diagonal = nullptr;
  /// What is added to the i-th diagonal entry.
  double operator()(std::uint32_t i) const { return diagonal ? lambda * diagonal[i] : lambda; }
};

enum class LinearStatus {
  kOk,
  kNotPositiveDefinite,  ///< a pivot was ≤ 0 or lost all its digits; `failed_block` names the block
  kNotFinite,            ///< the matrix or the right-hand side holds NaN or Inf
  kNotConverged,         ///< an iterative solver stopped at its iteration limit
  kStopped               ///< SolveControl::stop was raised
};

struct FactorResult {
  LinearStatus status = LinearStatus::kOk;
  std::uint32_t failed_block =
      BlockStructure::kAbsent;  ///< in the numbering of the structure, not of the ordering
  /// The scalar of the system whose pivot was lost, or kAbsent if the solver does not know.
  std::uint32_t failed_scalar = BlockStructure::kAbsent;
};

/// How exactly to solve, and when to give up: an argument of both verbs, because a solver may also prepare
/// less if less is asked for.
struct SolveControl {
  /// Iterative solvers, and refinement, stop at ‖b − (A + λD) x‖ ≤ relative_tolerance · ‖b‖: the forcing term
  /// of an inexact Newton method. Direct solvers need not look at it.
  double relative_tolerance = 1e-10;
  int max_iterations = 0;  ///< iterative solvers; 0 = twice the number of scalars, at least 100
  StopToken stop = {};     ///< once raised, the call returns LinearStatus::kStopped as soon as it can
};

struct SolveResult {
  LinearStatus status = LinearStatus::kOk;
  int iterations = 0;  ///< of an iterative solver, or steps of refinement; for reports alone
  /// Whether x solves the system to within rounding, so that xᵀ(A + λD)x = bᵀx. Algorithms that need the
  /// curvature along an inexact x multiply by A. A solver that leaves this false is never wrong, only slower.
  bool exact = false;
  /// kNotPositiveDefinite: as in FactorResult, if only solve() finds it.
  std::uint32_t failed_block = BlockStructure::kAbsent;
  std::uint32_t failed_scalar = BlockStructure::kAbsent;
};

/// How direct solvers order the blocks.
enum class Ordering : std::uint8_t {
  kAutomatic,         ///< minimum degree, or nested dissection if it is predicted to save more than it costs
  kMinimumDegree,     ///< approximate minimum degree
  kNestedDissection,  ///< takes many times as long, and needs fewer operations for large fronts
};

/// The arithmetic of a direct solver.
enum class Precision : std::uint8_t {
  kAutomatic,  ///< double, or mixed if that is predicted to save time
  kDouble,
  /// The factor in float, with half of the memory and the time; each solution is refined with A, in double,
  /// to SolveControl::relative_tolerance. If this does not succeed, the solver goes on in double.
  kMixed
};
std::string_view to_string(Precision precision);

/// Facts about the systems to come. Choices that concern one solver alone are in the options of that solver
/// (boxplus/linear/make_linear_solver.h).
struct AnalyzeHints {
  int right_hand_sides = 1;  ///< the most that one solve() will be given
  int threads = 1;
  /// How many of the first blocks a solver may eliminate one by one, because no two of them are joined
  /// (make_schur_solver()). Others may ignore it.
  std::uint32_t eliminated_blocks = 0;
  /// Blocks that must come last in the elimination order, in this order. May be empty. (optimize() and
  /// covariance() name blocks of components that nothing anchors, so that pivots are lost there; an
  /// incremental solver names the blocks that change next.)
  std::span<const std::uint32_t> last = {};
  /// An elimination order of all blocks to take rather than to look for one: that of another structure with
  /// the same or almost the same pattern. Empty: none. Read during analyze() alone; not used with `last`.
  std::span<const std::uint32_t> order = {};
  /// A may be singular, and factorize() should name the pivot that is lost. (A factor in float cannot.)
  bool may_be_singular = false;
};

/// How a structure has grown since it was analyzed: by blocks at its end, and by off-diagonal blocks.
struct StructureGrowth {
  std::uint32_t old_blocks = 0;
  std::span<const BlockCoordinate> added = {};    ///< the new off-diagonal blocks, each once
  std::span<const std::uint32_t> new_index = {};  ///< of each old off-diagonal or diagonal block k, ascending
};

/// Facts about the analysis, for reports.
struct LinearStatistics {
  std::uint64_t factor_nonzeros = 0;  ///< scalars of L with the zeros that amalgamation added
  double factor_flops = 0;            ///< useful floating-point operations of one factorisation
  std::uint32_t supernodes = 0;
  std::uint32_t largest_front = 0;  ///< scalars
  double factor_seconds = 0;        ///< predicted for one factorisation on one thread
  /// LinearSolverKind::kAutomatic: predicted for one rough solution by pcg on one thread.
  double pcg_seconds = 0;
  /// LinearSolverKind::kAutomatic: not 0 where it chose pcg, since a Cholesky factor would take this much
  /// memory, or far more time than pcg.
  std::uint64_t refused_factor_bytes = 0;
  Ordering ordering = Ordering::kMinimumDegree;  ///< of the blocks, where there is one
  Precision precision = Precision::kDouble;      ///< of the factor in use
  int workers = 1;                               ///< threads that factorise
  bool left_mixed = false;  ///< the factor in float did not do, or pay, and the solver went on in double
};

/// Solves symmetric positive definite block systems of one structure.
///
/// Called as: analyze() once per structure; factorize() once per linearization and damping; solve() any
/// number of times after each factorize(). After the first factorize() and solve() of a structure, further
/// calls of both allocate no memory, with two exceptions: the block Cholesky if it gives up a factor in float
/// for one in double, and kEigenSparse, whose library allocates some 25 times per factorization. A solver is
/// used by one thread at a time. Results are the same bits in every run and for every AnalyzeHints::threads.
///
/// A factorize() that was stopped must be called again before solve(). If analyze() or extend() throws
/// Stopped, analyze() must be called before factorize(). The values of a system must stay as they were from
/// factorize() to the last solve() after it.
class LinearSolver {
 public:
  enum class Needs { kBlocks, kOperator };

  virtual ~LinearSolver() = default;
  virtual std::string_view name() const = 0;
  virtual Needs needs() const = 0;
  /// Ordering, symbolic factorization and memory. `structure` must outlive the solver's use of it. May throw
  /// Stopped if `stop` is raised.
  virtual void analyze(const BlockStructure& structure, const AnalyzeHints& hints,
                       const StopToken& stop = {}) = 0;
  /// Instead of analyze(), after additions to the analyzed structure, which is the same object: keeps the
  /// elimination order and appends the new blocks, in a small part of the time. False if the solver cannot do
  /// so or predicts that a new order pays; then call analyze(). May throw Stopped if `stop` is raised.
  virtual bool extend(const StructureGrowth& /*growth*/, const StopToken& /*stop*/ = {}) { return false; }
  /// Factorizes (direct) or prepares the preconditioner (iterative) of A + λ D.
  virtual FactorResult factorize(const BlockSystem& system, const Damping& damping,
                                 const SolveControl& control = {}) = 0;
  /// X = (A + λ D)⁻¹ B for `columns` right-hand sides, each contiguous (column-major); B and X may be the
  /// same.
  virtual SolveResult solve(const double* b, int columns, double* x, const SolveControl& control = {}) = 0;
  /// Blocks of (A + λ D)⁻¹: for each requested (row, column), row ≥ column, dim(row) × dim(column) values,
  /// column-major, one after the other. False if the solver cannot do it, or `stop` is raised.
  virtual bool selected_inverse(std::span<const BlockCoordinate> /*blocks*/, double* /*out*/,
                                const StopToken& /*stop*/ = {}) {
    return false;
  }
  virtual LinearStatistics statistics() const { return {}; }
  /// The order in which the blocks are eliminated; empty if there is none. Valid until the next analyze().
  virtual std::span<const std::uint32_t> elimination_order() const { return {}; }
};

}  // namespace boxplus
