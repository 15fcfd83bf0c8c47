// SPDX-License-Identifier: BSD-3-Clause
#include "linear/schur/schur_solver.h"

#include <algorithm>
#include <string>

#include "boxplus/base/error.h"
#include "linear/column_inverse.h"
#include "linear/finite_check.h"
#include "linear/schur/schur_inverse.h"

namespace boxplus {
namespace {

/// Throws if an index is neither kAbsent nor below `count`.
void check_index(std::uint32_t index, std::uint32_t count, const char* member, const LinearSolver& solver) {
  if (index == BlockStructure::kAbsent || index < count) return;
  throw InvalidArgument("the linear solver '" + std::string(solver.name()) + "' returned the " + member +
                        " " + std::to_string(index) +
                        ": expected BlockStructure::kAbsent or an index below " + std::to_string(count));
}

/// Returns the result of a solver for systems of this structure. If the result names a block or a scalar that
/// does not exist, throws InvalidArgument.
template <class Result>
Result checked(const Result& result, const LinearSolver& solver, const BlockStructure& structure) {
  if (result.status == LinearStatus::kOk) return result;
  check_index(result.failed_block, structure.blocks(), "failed_block", solver);
  check_index(result.failed_scalar, structure.scalars(), "failed_scalar", solver);
  return result;
}

}  // namespace

std::shared_ptr<LinearSolver> make_schur_solver(std::shared_ptr<LinearSolver> inner, SchurMode mode) {
  return std::make_shared<SchurSolver>(std::move(inner), mode, KeptBlocks::kSeparate);
}

void SchurSolver::analyze(const BlockStructure& structure, const AnalyzeHints& hints, const StopToken& stop) {
  factorized_ = false;
  reduced_.reset();
  schur_.reset();
  structure_ = &structure;
  const std::uint32_t eliminated = hints.eliminated_blocks;
  if (eliminated == 0 || eliminated == structure.blocks()) return inner_->analyze(structure, hints, stop);
  const bool make_values = mode_ == SchurMode::kExplicit || inner_->needs() != Needs::kOperator;
  auto schur = std::make_unique<Schur>(structure, hints, make_values, kept_, stop);
  if (make_values) {
    reduced_ = std::make_unique<AssembledSystem>(schur->reduced_structure(), schur->reduced_values());
  } else {
    reduced_ = std::make_unique<ImplicitSchur>(*schur);
  }
  schur_ = std::move(schur);
  batch_ = std::max(1, hints.right_hand_sides);
  reduced_vectors_.resize(std::size_t{schur_->reduced_structure().scalars()} *
                          static_cast<std::size_t>(batch_));
  std::vector<std::uint32_t> last;
  for (const std::uint32_t block : hints.last) {
    if (block < eliminated) continue;
    const std::uint32_t in_s = schur_->place_of(block).block;
    if (std::find(last.begin(), last.end(), in_s) == last.end()) last.push_back(in_s);
  }
  inner_->analyze(schur_->reduced_structure(),
                  {.right_hand_sides = batch_,
                   .threads = hints.threads,
                   .last = last,
                   .may_be_singular = hints.may_be_singular},
                  stop);
}

void SchurSolver::move_to_full_numbering(std::uint32_t& block, std::uint32_t& scalar) const {
  if (block != BlockStructure::kAbsent) {
    const bool is_known = scalar != BlockStructure::kAbsent;
    block = schur_->block_with(is_known ? scalar : schur_->reduced_structure().offset[block]);
  }
  if (scalar != BlockStructure::kAbsent) scalar += schur_->eliminated_scalars();
}

FactorResult SchurSolver::factorize(const BlockSystem& system, const Damping& damping,
                                    const SolveControl& control) {
  if (!structure_) throw InvalidArgument("SchurSolver::factorize: expected an earlier call of analyze()");
  if (!eliminates()) return checked(inner_->factorize(system, damping, control), *inner_, *structure_);
  factorized_ = false;
  reduced_for_ = nullptr;
  if (system.values().size() != structure_->nonzero_values())
    throw InvalidArgument("SchurSolver::factorize: expected the block values of the analyzed structure");
  if (control.stop.raised()) return {LinearStatus::kStopped};
  if (reduced_->values().empty()) {  // the inner solver sees no values that it could check
    const std::uint32_t not_finite = find_not_finite(*structure_, system.values().data(), damping);
    if (not_finite != BlockStructure::kAbsent) return {LinearStatus::kNotFinite, not_finite};
  }
  const FactorResult result = schur_->eliminate(system.values(), damping, control.stop,
                                                control.right_hand_side, reduced_vectors_.data());
  return result.status == LinearStatus::kOk ? factorize_reduced(system.values(), damping, control) : result;
}

FactorResult SchurSolver::finish(std::span<const double> values, const Damping& damping,
                                 const SolveControl& control) {
  factorized_ = false;
  reduced_for_ = nullptr;
  const FactorResult result = schur_->finish(values, reduced_vectors_.data());
  return result.status == LinearStatus::kOk ? factorize_reduced(values, damping, control) : result;
}

/// Factorizes the Schur complement. `values` are those of H, or of its kept columns.
FactorResult SchurSolver::factorize_reduced(std::span<const double> values, const Damping& damping,
                                            const SolveControl& control) {
  SolveControl inner_control = control;
  inner_control.right_hand_side = nullptr;
  FactorResult result = checked(inner_->factorize(*reduced_, schur_->reduced_damping(damping), inner_control),
                                *inner_, schur_->reduced_structure());
  factorized_ = result.status == LinearStatus::kOk;
  if (factorized_) reduced_for_ = control.right_hand_side;
  move_to_full_numbering(result.failed_block, result.failed_scalar);
  if (result.status != LinearStatus::kNotFinite) return result;
  const bool has_all = values.size() == structure_->nonzero_values();
  const std::uint32_t cause =
      find_not_finite(*structure_, values.data(), damping, has_all ? 0 : schur_->eliminated_blocks());
  return cause == BlockStructure::kAbsent ? result : FactorResult{result.status, cause};
}

SolveResult SchurSolver::solve(const double* b, int columns, double* x, const SolveControl& control) {
  if (!eliminates()) return checked(inner_->solve(b, columns, x, control), *inner_, *structure_);
  if (!factorized_) throw InvalidArgument("SchurSolver::solve: expected an earlier successful factorize()");
  const std::size_t size = structure_->scalars();
  if (!all_finite(b, size * static_cast<std::size_t>(std::max(0, columns))))
    return {LinearStatus::kNotFinite};
  SolveResult total{.exact = true};
  for (int done = 0; done < columns && total.status == LinearStatus::kOk; done += batch_) {
    const std::size_t first = static_cast<std::size_t>(done) * size;
    const SolveResult result = solve_batch(b + first, std::min(batch_, columns - done), x + first, control);
    total = {result.status, total.iterations + result.iterations, total.exact && result.exact,
             result.failed_block, result.failed_scalar};
  }
  return total;
}

/// Solves for at most batch_ columns.
SolveResult SchurSolver::solve_batch(const double* b, int columns, double* x, const SolveControl& control) {
  const std::size_t size = structure_->scalars(), kept = schur_->reduced_structure().scalars();
  double* reduced = reduced_vectors_.data();
  const bool is_reduced = columns == 1 && reduced_for_ == b;
  reduced_for_ = nullptr;  // because the solution replaces the right-hand side
  for (std::size_t c = is_reduced ? 1 : 0; c < static_cast<std::size_t>(columns); ++c)
    schur_->reduce(b + c * size, reduced + c * kept);
  const SolveResult result = solve_reduced(columns, control);
  if (result.status != LinearStatus::kOk && result.status != LinearStatus::kNotConverged) return result;
  for (std::size_t c = 0; c < static_cast<std::size_t>(columns); ++c)
    schur_->back_substitute(b + c * size, reduced + c * kept, x + c * size);
  return result;
}

/// Replaces the right-hand sides of the reduced system by their solutions.
SolveResult SchurSolver::solve_reduced(int columns, const SolveControl& control) {
  SolveResult result =
      checked(inner_->solve(reduced_vectors_.data(), columns, reduced_vectors_.data(), control), *inner_,
              schur_->reduced_structure());
  move_to_full_numbering(result.failed_block, result.failed_scalar);
  return result;
}

SolveResult SchurSolver::solve_kept(double* x, const SolveControl& control) {
  reduced_for_ = nullptr;
  const SolveResult result = solve_reduced(1, control);
  std::copy_n(reduced_vectors_.data(), schur_->reduced_structure().scalars(),
              x + schur_->eliminated_scalars());
  return result;
}

bool SchurSolver::selected_inverse(std::span<const BlockCoordinate> blocks, double* out,
                                   const StopToken& stop) {
  if (!eliminates()) return inner_->selected_inverse(blocks, out, stop);
  if (!factorized_)
    throw InvalidArgument("SchurSolver::selected_inverse: expected an earlier successful factorize()");
  return invert_blocks(*schur_, *inner_, list_requests(*structure_, blocks, out), stop);
}

}  // namespace boxplus
