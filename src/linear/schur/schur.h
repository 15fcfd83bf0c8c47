// SPDX-License-Identifier: BSD-3-Clause
// Eliminates a set of vertices by the Schur complement, which is either an explicit matrix or an operator.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "boxplus/base/function_ref.h"
#include "boxplus/linear/block_system.h"
#include "boxplus/linear/linear_solver.h"
#include "linear/schur/elimination_kernel_choice.h"

namespace boxplus {

class PacedStop;

/// The blocks of S.
enum class KeptBlocks : std::uint8_t {
  kSeparate,  ///< those of H
  kJoined     ///< consecutive blocks of H are joined if this saves time
};

/// Let H = [V Wᵀ; W U]. V belongs to the eliminated vertices, which are the first blocks of H, and is block
/// diagonal. Solves (H + λD) x = r by means of the Schur complement S = U + λD − W (V + λD)⁻¹ Wᵀ. H does not
/// change, so a different λ needs no new assembly of H. (Brown, "A solution to the general problem of
/// multiple station analytical stereotriangulation", 1958; Triggs et al., "Bundle adjustment: a modern
/// synthesis", 2000, §6.1.)
///
/// S has one block per kept block of H, or one for several of them: consecutive kept blocks that are coupled
/// with the same eliminated blocks can be joined, such as a pose and its camera. Then S has fewer pairs of
/// blocks, and their products take less time. The scalars of S are those of the kept blocks, in the same
/// order.
///
/// The eliminated blocks are divided into slices. One thread eliminates the blocks of a slice, in order, and
/// adds to a copy of S. Then the copies are added in order. The number of slices depends only on the
/// structure, so the bits of S do not depend on the number of threads.
///
/// Only the constructor allocates memory. `structure` must outlive this object.
class Schur {
 public:
  /// Eliminates hints.eliminated_blocks blocks, with at most hints.threads threads. Slices begin only at
  /// columns in hints.elimination_bounds. No block is joined to one that is in hints.last, so that this block
  /// can be the last of all. Throws Stopped when the token is raised.
  Schur(const BlockStructure& structure, const AnalyzeHints& hints, bool explicit_values,
        KeptBlocks kept = KeptBlocks::kSeparate, const StopToken& stop = {});

  /// Leaves scalars of H out of S and of reduced_r: their rows and columns become zero, except for the
  /// diagonal, which stays that of H. The result is the same as if their rows in W were zero, and so they may
  /// have any values. In U and in r, they must be left out already. Ignores scalars of eliminated blocks. If
  /// S is not explicit, does nothing for S.
  void leave_out(std::span<const std::uint32_t> scalars);

  const BlockStructure& reduced_structure() const { return reduced_; }
  /// The place of a kept block in S: the block of S that contains it, and its first scalar in this block.
  struct Place {
    std::uint32_t block, first;
  };
  Place place_of(std::uint32_t block_of_h) const { return places_[block_of_h - eliminated_]; }
  /// The block of H that contains a scalar of S.
  std::uint32_t block_with(std::uint32_t reduced_scalar) const;
  const BlockStructure& structure() const { return *structure_; }
  std::uint32_t eliminated_blocks() const { return eliminated_; }
  std::uint32_t eliminated_scalars() const { return structure_->offset[eliminated_]; }

  /// Factorizes V + λD. With `explicit_values`, also computes S, but without the λD of the kept blocks, which
  /// the linear solver adds. `values` are the values of H. They must not change until the last call of any
  /// function of this object. If a block is not positive definite, the result names the block of H and the
  /// scalar. Returns LinearStatus::kStopped soon after the token is raised. If `r` is not null, also computes
  /// reduced_r as reduce() does: this is faster than a call of reduce(), because W is in the cache.
  FactorResult eliminate(std::span<const double> values, const Damping& damping, const StopToken& stop = {},
                         const double* r = nullptr, double* reduced_r = nullptr);

  /// The same in steps, while H, the damping and r are being computed. First, call begin(). Then, call
  /// eliminate_columns() for all columns of each slice, in order, as soon as the columns [first, last) of H
  /// and their part of the damping and of r are complete. Different threads may do this for different slices.
  /// `values` begins with the first value of these columns. When H and r are complete, call finish() with the
  /// values of H. If the eliminated columns are not stored, pass the values of the kept columns; functions
  /// that read eliminated columns must then not be called: reduce(), back_substitute(), for_each_coupled(),
  /// multiply() and block_diagonal().
  void begin(const Damping& damping, const double* r);
  void eliminate_columns(int slice, std::uint32_t first, std::uint32_t last, const double* values,
                         const StopToken& stop);
  FactorResult finish(std::span<const double> values, double* reduced_r);
  int slices() const { return static_cast<int>(slices_.size()); }
  /// The part of a damping that belongs to the kept blocks.
  Damping reduced_damping(const Damping& damping) const;
  /// reduced_r = r_kept − W (V + λD)⁻¹ r_eliminated.
  void reduce(const double* r, double* reduced_r);
  /// Computes the eliminated part of x, (V + λD)⁻¹ (r_eliminated − Wᵀ reduced_x), and copies the kept part
  /// from reduced_x. x may be r.
  void back_substitute(const double* r, const double* reduced_x, double* x);

  /// x ← (V + λD)⁻¹ x for one eliminated block.
  void solve_eliminated(std::uint32_t block, double* x) const;
  /// Calls f(kept block, values of the block of W, its number of rows) for each nonzero block of W in the
  /// column of the block `eliminated`.
  template <class F>
  void for_each_coupled(std::uint32_t eliminated, F&& f) const {
    for_each_coupled(eliminated, blocks_of_w(eliminated), f);
  }

  /// The values of S without the λD of the kept blocks. Empty unless `explicit_values` was true.
  std::span<const double> reduced_values() const { return reduced_values_; }
  /// y = (U − W (V + λD)⁻¹ Wᵀ) x. Does not form S.
  void multiply(const double* x, double* y);
  /// Computes the diagonal blocks of S without the λD of the kept blocks.
  void block_diagonal(double* out);

 private:
  /// What leave_out() leaves out.
  struct LeftOut {
    std::vector<std::uint32_t> scalars;  // of reduced_r
    std::vector<std::uint32_t> values;   // of S
    /// Entries of the diagonal: in S, and among the kept values of H.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> diagonals;
  };
  struct Slice {
    std::uint32_t first, last;         // its columns
    std::size_t first_pair = 0;        // in pair_target_
    const std::uint32_t* next_target;  // of the next column
    FactorResult result;
    double *values, *reduced_r;       // its copies
    std::vector<double> half_column;  // W L⁻ᵀ of one column, with the blocks of S
    std::vector<int> half_rows;       // the number of rows of each block in half_column
    std::vector<double> small;        // a vector of the size of an eliminated block
  };

  /// The same. `w` is the first value of the blocks of W in the column.
  template <class F>
  void for_each_coupled(std::uint32_t eliminated, const double* w, F&& f) const {
    const std::uint32_t begin = structure_->column_start[eliminated] + 1,
                        end = structure_->column_start[eliminated + 1];
    for (std::uint32_t k = begin; k < end; ++k) {
      const std::uint32_t row = structure_->row[k];
      f(row - eliminated_, w, static_cast<int>(structure_->dim(row)));
      w += structure_->value_start[k + 1] - structure_->value_start[k];
    }
  }
  /// The first scalar of S that belongs to a kept block of H.
  std::uint32_t reduced_offset(std::uint32_t kept) const {
    return structure_->offset[eliminated_ + kept] - eliminated_scalars();
  }
  std::uint32_t first_kept_value() const {
    return structure_->value_start[structure_->column_start[eliminated_]];
  }
  /// The stored values of the blocks of W in a column.
  const double* blocks_of_w(std::uint32_t column) const {
    return values_.data() + structure_->value_start[structure_->column_start[column] + 1];
  }

  /// Calls f(row, column, k) for each block of U, the k-th block of H, in the order of kept_target_.
  template <class F>
  void for_each_block_of_u(F&& f) const {
    for (std::uint32_t column = eliminated_; column < structure_->blocks(); ++column) {
      for (std::uint32_t k = structure_->column_start[column]; k < structure_->column_start[column + 1]; ++k)
        f(structure_->row[k], column, k);
    }
  }
  std::uint32_t count_reduced_blocks(std::uint32_t column) const;
  void set_targets(PacedStop& pace);
  void make_slices(std::span<const std::uint32_t> bounds, PacedStop& pace);
  std::vector<std::uint32_t> bounds_of_equal_parts(std::uint32_t count) const;
  FactorResult factorize_block(std::uint32_t block, const double* v, double* l) const;
  FactorResult failure(std::uint32_t block, const double* v, std::uint32_t pivot) const;
  void for_each_slice(detail::FunctionRef<void(Slice&)> f);
  void clear(Slice& slice);
  std::uint32_t whiten_column(std::uint32_t column, const double* w, const double* l, Slice& slice) const;
  void subtract_products(int dim, std::uint32_t blocks, const std::uint32_t* target, Slice& slice) const;
  void reduce_column(std::uint32_t column, const double* w, const double* r, Slice& slice) const;
  void add_reduced_copies(const double* r, double* reduced_r) const;
  void clear_left_out(std::span<const double> kept_values);
  void add_copies(std::span<const double> values);
  void add_block_of_u(std::uint32_t row, std::uint32_t column, const double* block, double* to) const;
  void kept_multiply(const double* x, double* y) const;

  const BlockStructure* structure_;
  std::uint32_t eliminated_;
  std::vector<Place> places_;  // of each kept block
  BlockStructure reduced_;
  int threads_;
  EliminationKernelChoice kernels_;
  std::span<const double> values_;  // of H; without the eliminated columns if they are not stored
  Damping damping_;
  const double* r_ = nullptr;
  std::vector<std::uint32_t> factor_start_;  // the index in factors_ for each eliminated block
  std::vector<double> factors_;              // L of V + λD, dim × dim, with 1/L_ii on the diagonal
  std::vector<double> reduced_values_;
  std::vector<std::uint32_t> kept_target_;  // the first value in S of each kept block of H
  /// The first value in S of each pair of blocks of S (a ≥ b) that an eliminated column has.
  std::vector<std::uint32_t> pair_target_;
  std::vector<Slice> slices_;
  LeftOut left_out_;
  std::vector<double> copies_, reduced_copies_;  // of S for all slices but the first; of reduced_r for all
  std::vector<std::uint32_t> diagonal_start_;  // the first value of each block of S among the diagonal blocks
};

/// The Schur complement S as an operator, without an explicit matrix.
class ImplicitSchur final : public BlockSystem {
 public:
  explicit ImplicitSchur(Schur& schur) : schur_(&schur) {}
  const BlockStructure& structure() const override { return schur_->reduced_structure(); }
  std::span<const double> values() const override { return {}; }
  void multiply(const double* x, double* y) const override { schur_->multiply(x, y); }
  void block_diagonal(double* out) const override { schur_->block_diagonal(out); }

 private:
  Schur* schur_;
};

}  // namespace boxplus
