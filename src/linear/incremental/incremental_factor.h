// SPDX-License-Identifier: BSD-3-Clause
// A sparse Cholesky factor that follows the changes of its matrix: H = Σ of small dense terms, and the
// solution of H x = −g.
//
// The factor is a forest of fronts. Each front keeps its panel and its update matrix, with the right-hand
// side as the last row. If terms change, only their fronts and the ancestors of these have to be computed
// again (numerically); if terms come or go, the fronts on the paths from their blocks to the roots are taken
// apart, and their blocks are ordered anew. The subtrees below keep everything (Kaess et al., "iSAM2",
// IJRR 2012).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernels/kernel_table.h"
#include "linear/block_cholesky/symbolic_factor.h"
#include "linear/incremental/sized_memory.h"

namespace boxplus {

/// What IncrementalFactor::factorize() did.
struct FactorWork {
  std::uint32_t ordered_blocks = 0;     ///< blocks that were ordered anew
  std::uint32_t factorized_fronts = 0;  ///< fronts that were computed
  std::uint32_t factorized_scalars = 0;
  double flops = 0;
};

class IncrementalFactor {
 public:
  using Index = std::uint32_t;
  static constexpr Index kNone = 0xFFFFFFFFu;

  // ---- The matrix ----

  /// Adds a block of unknowns, which has no term yet, and returns its index. Its size is that of
  /// `noticeable`: changes of an entry of x below its noticeable change are not passed on by solve().
  Index add_block(std::span<const double> noticeable);
  /// Removes a block that has no terms.
  void remove_block(Index block);
  /// Adds a term on the given blocks, which must be distinct. Its values are zero.
  Index add_term(std::span<const Index> blocks);
  void remove_term(Index term);
  /// Sets the values of a term to zero, and says that the caller will change them.
  void clear_term(Index term);
  /// Entries of the term's gradient and blocks in values(): the gradient of each block, and then the blocks
  /// (i, j), j ≤ i, in the order (0,0) (1,0) (1,1) (2,0) …, column-major. The diagonal blocks hold both of
  /// their triangles. Valid until add_term().
  double* values() { return values_.data(); }
  std::span<const double> values_of(Index term) const {
    return std::span(values_).subspan(terms_[term].values, terms_[term].size);
  }
  /// The places of a term's parts among the values: of the gradient of its i-th block, and of block (i, j).
  std::uint32_t gradient_of(Index term, std::size_t i) const;
  std::uint32_t block_of(Index term, std::size_t i, std::size_t j) const;
  std::span<const Index> blocks_of(Index term) const { return terms_[term].blocks; }
  std::span<const Index> terms_of(Index block) const { return blocks_[block].terms; }
  /// The root of the block's tree, or kNone before the block is factorized. The number changes when the root
  /// is built anew.
  Index root_of(Index block) const;
  std::uint32_t dim(Index block) const { return blocks_[block].dim; }
  /// Scalars of x that are held at zero. The caller must clear their rows and columns in all terms.
  void hold_scalars(Index block, std::span<const int> scalars);
  std::span<const int> held_scalars(Index block) const { return blocks_[block].held; }

  // ---- Predictions ----

  /// Forgets what expect_change() has counted.
  void begin_prediction() { ++prediction_; }
  /// The operations that factorize() needs because the terms of this block change, in addition to those that
  /// were predicted since begin_prediction(). Counts them if they are at most `limit`.
  double expect_change(Index block, double limit);

  // ---- The solution ----

  struct Result {
    LinearStatus status = LinearStatus::kOk;
    Index lost_block = kNone;    // if not positive definite
    bool is_suspicious = false;  // a pivot lost so many digits that its direction may be undetermined
  };
  /// Brings the factor up to date. If a pivot is lost or the token is raised, the next call continues.
  Result factorize(const StopToken& stop, FactorWork& work);
  /// Brings x up to date, as far as its changes are noticeable, and appends the blocks whose x was computed.
  void solve(std::vector<Index>& solved);
  /// Computes all of x.
  void solve_all(std::vector<Index>& solved);
  std::span<const double> x(Index block) const { return {x_.data() + blocks_[block].x, blocks_[block].dim}; }
  const double* all_x() const { return x_.data(); }
  std::uint32_t x_offset(Index block) const { return blocks_[block].x; }
  /// Says that the unknowns of this block are now relative to x: x becomes zero. The terms of the block must
  /// change before the next factorize().
  void reset_x(Index block);

  /// The part of H⁻¹ that belongs to the listed blocks, in this order; column-major. Visits the fronts
  /// between the blocks and the roots (Kaess and Dellaert, "Covariance recovery from a square root
  /// information matrix for data association", RAS 2009). The factor must be up to date.
  void covariance(std::span<const Index> blocks, std::vector<double>& out);

  /// The number of scalars of all blocks.
  std::uint32_t scalars() const { return scalars_; }

 private:
  /// The scalars of a block in x.
  struct Place {
    std::uint32_t x, dim;
  };
  struct Block {
    std::uint32_t dim = 0, x = 0;
    Index front = kNone;
    std::uint64_t sequence = 0;  // blocks that are eliminated later have higher numbers
    std::uint64_t age = 0;       // the number of the block in the order of their additions
    std::vector<Index> terms;
    std::vector<int> held;
    bool is_alive = false, is_touched = false;
  };
  struct Term {
    std::vector<Index> blocks;
    std::uint32_t values = 0, size = 0;
    bool is_changed = false;
  };
  struct Front {
    std::vector<Index> blocks;  // the pivots, and then the separator, in the order of elimination
    std::vector<Place> places;  // of each block
    std::vector<Index> children;
    std::vector<dense::Run> runs;  // of the rows of the update matrix, in the parent's front
    std::size_t pivot_runs = 0;
    Index pivots = 0, parent = kNone;
    std::uint32_t columns = 0, below = 0, leading = 0;  // `below` contains the right-hand side
    double* values = nullptr;                           // the panel, and then the update matrix
    std::uint64_t prediction = 0;                       // the last one that counts this front
    bool is_moved = false;     // its rows have moved, so that the runs of its children are out of date
    bool is_dirty = false;     // is to be computed
    bool is_unsolved = false;  // was computed after the last solve()
    bool is_top = false;       // is being taken apart

    double flops() const {
      const double all = columns + below, rest = below;
      return (all * all * all - rest * rest * rest) / 3;
    }
    std::size_t panel_size() const { return std::size_t{leading} * columns; }
    std::size_t size() const { return panel_size() + std::size_t{below} * below; }
    std::span<const Index> pivot_blocks() const { return std::span(blocks).first(pivots); }
    std::span<const Index> separator() const { return std::span(blocks).subspan(pivots); }
    double* update() const { return values + panel_size(); }
  };
  /// The part of the forest that is ordered anew.
  struct Top {
    std::vector<Index> fronts, blocks, orphans;
    std::vector<std::pair<Index, Index>> orphans_of;  // places of blocks, and orphans below them; scratch
  };

  void touch(Index block);
  void mark_changed();
  void mark_path(Index front);
  void take_top_apart(FactorWork& work);
  void rebuild();
  BlockStructure structure_of_top();
  void find_blocks(Front& front);
  Index new_front();
  void free_front(Index f);
  void set_places(Front& front) const;
  bool sort_blocks(Front& front);
  void sort_separator(Front& front);
  void attach(Index child, Index parent);
  void find_runs(Front& child, const Front& parent);
  Result factorize_front(Front& front, const StopToken& stop);
  void load(Front& front);
  void load_term(const Term& term, Index pivot, double* columns, std::uint32_t leading,
                 std::uint32_t last) const;
  void solve_front(const Front& front, std::vector<Index>& solved);

  std::vector<Block> blocks_;
  std::vector<Term> terms_;
  std::vector<Front> fronts_;
  std::vector<Index> free_blocks_, free_terms_, free_fronts_;
  std::vector<double> values_;
  std::vector<std::vector<std::uint32_t>> free_values_;  // per SizedMemory::class_of()
  std::vector<double> x_, published_, noticeable_;       // per scalar
  std::vector<std::vector<std::uint32_t>> free_x_;       // per size
  SizedMemory memory_;
  std::uint64_t prediction_ = 0;
  std::uint64_t sequence_ = 0, age_ = 0, pass_ = 0;
  std::uint32_t scalars_ = 0;

  std::vector<Index> touched_, changed_terms_, dirty_, new_roots_;
  // Scratch memory.
  Top top_;
  std::vector<std::uint32_t> mark_;  // of each block
  std::uint32_t marks_ = 0;
  std::vector<std::uint32_t> local_;         // of each block, in the top or in a front
  std::vector<std::uint64_t> noticed_pass_;  // of each block: the solve() in which its change was noticed
  std::vector<double> work_, minimum_pivot_, permuted_, columns_;
  std::vector<Index> stack_;
};

}  // namespace boxplus
