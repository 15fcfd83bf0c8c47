// SPDX-License-Identifier: BSD-3-Clause
// The interface between the optimizer and the solvers of (A + λ D) x = b.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "boxplus/base/stop_token.h"
#include "boxplus/linear/block_system.h"
#include "boxplus/linear/linear_statistics.h"

namespace boxplus {

/// λ D, which the solver adds to A. D is the identity if `diagonal` is null. Otherwise D = diag(diagonal),
/// with one value ≥ 0 per scalar of the system.
struct Damping {
  double lambda = 0;
  const double* diagonal = nullptr;
  /// The value that is added to the i-th diagonal entry.
  double operator()(std::uint32_t i) const { return diagonal ? lambda * diagonal[i] : lambda; }
};

enum class LinearStatus {
  kOk,
  kNotPositiveDefinite,  ///< a pivot was ≤ 0 or lost all its digits; `failed_block` names the block
  kNotFinite,            ///< the matrix or the right-hand side holds NaN or Inf
  kNotConverged,         ///< an iterative solver stopped at its iteration limit
  kStopped               ///< SolveControl::stop was raised
};

/// If the status is not kOk, failed_block and failed_scalar must exist in the analyzed structure, or be
/// kAbsent. Otherwise, optimize() throws InvalidArgument.
struct FactorResult {
  LinearStatus status = LinearStatus::kOk;
  std::uint32_t failed_block =
      BlockStructure::kAbsent;  ///< its index in the structure, not in the elimination order
  /// The scalar of the system whose pivot was lost, or kAbsent if the solver does not know.
  std::uint32_t failed_scalar = BlockStructure::kAbsent;
};

/// How accurately to solve, and when to give up. Not only solve() but also factorize() takes a SolveControl,
/// because a solver may save work in both functions if less accuracy is required.
struct SolveControl {
  /// Iterative solvers and refinement stop when ‖b − (A + λD) x‖ ≤ relative_tolerance · ‖b‖: the forcing term
  /// of an inexact Newton method. Direct solvers may ignore it.
  double relative_tolerance = 1e-10;
  int max_iterations = 0;  ///< for iterative solvers; 0: twice the number of scalars, at least 100
  StopToken stop = {};     ///< once raised, the call returns LinearStatus::kStopped as soon as it can
  /// Only for factorize(): the right-hand side of the next solve(), which gets the same pointer and values,
  /// or null. A solver may already use it. The result is the same.
  const double* right_hand_side = nullptr;
};

struct SolveResult {
  LinearStatus status = LinearStatus::kOk;
  int iterations = 0;  ///< of an iterative solver, or refinement steps; only for reports
  /// Whether x solves the system to within rounding, so that xᵀ(A + λD)x = bᵀx. If false, algorithms that
  /// need the curvature along x multiply by A. Therefore, false is always correct, but slower.
  bool exact = false;
  /// As in FactorResult, if the status is kNotPositiveDefinite and only solve() could detect this.
  std::uint32_t failed_block = BlockStructure::kAbsent;
  std::uint32_t failed_scalar = BlockStructure::kAbsent;
};

/// A system that several processes share. Each process passes the system of its own blocks, and the system to
/// be solved is the sum of these: of A, of λ D and of b. Each process gets its own blocks of x.
struct DividedSystem {
  std::span<const std::uint32_t> dims;    ///< the sizes of all blocks of the sum
  std::span<const std::uint32_t> blocks;  ///< the number in the sum of each block of this process, ascending
};

/// Facts about the systems to be solved. Each solver's own options are in
/// boxplus/linear/make_linear_solver.h.
struct AnalyzeHints {
  int right_hand_sides = 1;  ///< maximum number of columns in one solve()
  int threads = 1;
  /// The first `eliminated_blocks` blocks are not connected with each other, so a solver may eliminate them
  /// one by one (make_schur_solver()). Other solvers may ignore this.
  std::uint32_t eliminated_blocks = 0;
  /// Blocks that must come last in the elimination order, in this order. May be empty. (optimize() and
  /// covariance() list one block of each connected component that may have gauge freedom, so that this
  /// freedom makes the pivots of the block vanish. An incremental solver lists the blocks that change next.)
  std::span<const std::uint32_t> last = {};
  /// An elimination order of all blocks for the solver to use, from another structure with the same or almost
  /// the same pattern. If empty, the solver computes an order. Only analyze() reads it. Ignored if `last` is
  /// not empty.
  std::span<const std::uint32_t> order = {};
  /// Whether A may be singular. Then factorize() should name the pivot that vanishes. (With a factor in
  /// float, this is not possible.)
  bool may_be_singular = false;
  /// The eliminated blocks at which a solver may divide its work among threads: 0, …, eliminated_blocks,
  /// ascending. If empty, at any block. Only analyze() reads it.
  std::span<const std::uint32_t> elimination_bounds = {};
  /// For solvers that need contributions; otherwise null. Only analyze() reads it.
  const DividedSystem* divided = nullptr;
};

/// Solves symmetric positive definite block systems of one structure.
///
/// Call analyze() once per structure, factorize() once per linearization and damping, and solve() any number
/// of times after each factorize(). After the first factorize() and solve() of a structure, further calls of
/// both allocate no memory. There are two exceptions: the block Cholesky when it falls back from float to
/// double, and kEigenSparse, whose library allocates about 25 times per factorization. Only one thread may
/// use a solver at a time. Results have the same bits in every run and for any AnalyzeHints::threads.
///
/// If factorize() was stopped, call it again before solve(). If analyze() throws Stopped, call it again
/// before factorize(). The values of a system must not change between factorize() and the last solve() after
/// it.
class LinearSolver {
 public:
  /// The blocks of A; only products with A; or the blocks that this process contributes to A
  /// (AnalyzeHints::divided). In the last case, all processes call the same functions in the same order, and
  /// these return the same status and throw in all of them, except for lack of memory.
  enum class Needs { kBlocks, kOperator, kContributions };

  virtual ~LinearSolver() = default;
  virtual std::string_view name() const = 0;
  virtual Needs needs() const = 0;
  /// Orders the blocks, factorizes symbolically and allocates memory. `structure` must exist as long as the
  /// solver uses it. May throw Stopped if `stop` is raised.
  virtual void analyze(const BlockStructure& structure, const AnalyzeHints& hints,
                       const StopToken& stop = {}) = 0;
  /// Factorizes (direct) or prepares the preconditioner (iterative) of A + λ D.
  virtual FactorResult factorize(const BlockSystem& system, const Damping& damping,
                                 const SolveControl& control = {}) = 0;
  /// X = (A + λ D)⁻¹ B for `columns` right-hand sides, each contiguous (column-major). B and X may be the
  /// same memory.
  virtual SolveResult solve(const double* b, int columns, double* x, const SolveControl& control = {}) = 0;
  /// Blocks of (A + λ D)⁻¹: dim(row) × dim(column) values for each requested (row, column), row ≥ column;
  /// column-major, one block after the other. Returns false if the solver cannot do this, or if `stop` is
  /// raised.
  virtual bool selected_inverse(std::span<const BlockCoordinate> /*blocks*/, double* /*out*/,
                                const StopToken& /*stop*/ = {}) {
    return false;
  }
  virtual LinearStatistics statistics() const { return {}; }
  /// The order in which the solver eliminates the blocks; empty if it has none. Valid until the next
  /// analyze().
  virtual std::span<const std::uint32_t> elimination_order() const { return {}; }
};

}  // namespace boxplus
