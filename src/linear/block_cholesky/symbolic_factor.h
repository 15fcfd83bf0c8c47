// SPDX-License-Identifier: BSD-3-Clause
// The symbolic factorization of the block Cholesky: everything that depends only on the structure.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boxplus/linear/block_structure.h"
#include "boxplus/linear/linear_solver.h"
#include "kernels/kernel_table.h"
#include "linear/block_cholesky/supernodes.h"
#include "linear/block_cholesky/tree_schedule.h"

namespace boxplus {

/// A run of consecutive scalars and its destination.
using ScalarRun = dense::Run;

/// Describes how one block of A is copied to the panel of its supernode. `source` is an offset in the values
/// of A, and `destination` is an offset in the panel.
struct BlockCopy {
  std::uint32_t source, destination;
  std::uint32_t rows, columns;  // as stored in A
  bool transposed;
};

/// One supernode. Its panel is the lower trapezoid [L11; L21] of (columns + below) × columns values. The
/// panel is column-major, with the leading dimension `leading`. The update matrix has below × below values,
/// but only its lower triangle is used.
struct Front {
  std::uint32_t first_block, end_block;  // positions in the elimination order
  std::uint32_t columns, below;          // in scalars
  std::uint32_t leading;
  std::uint32_t parent = kNoParent;
  std::uint64_t panel = 0, update = 0;         // addresses in the arena
  std::uint32_t row_begin = 0, row_end = 0;    // range in row_blocks: positions of the blocks below
  std::uint32_t copy_begin = 0, copy_end = 0;  // range in copies
  std::uint32_t child_begin = 0, child_end = 0;
  /// A range of `runs`, which map the rows of the update matrix to scalars of the parent's front. The runs
  /// before run_split map rows to pivots of the parent.
  std::uint32_t run_begin = 0, run_split = 0, run_end = 0;
  std::uint32_t row_run_begin = 0, row_run_end = 0;  // range in row_runs: update rows → permuted scalars
  std::uint64_t first_row = 0;                       // index of the first row among the rows of all fronts
  std::uint32_t rows() const { return columns + below; }
};

struct SymbolicFactor {
  std::vector<std::uint32_t> order, position;  // position → block of the structure, and back
  std::vector<std::uint32_t> offset;    // first permuted scalar of each position, and their total number
  std::vector<std::uint32_t> front_of;  // position → supernode
  std::vector<Front> fronts;
  TreeSchedule schedule;
  std::vector<std::uint32_t> row_blocks, children;
  std::vector<std::uint32_t> row_offsets;  // the first row in the front, for each element of row_blocks
  std::vector<BlockCopy> copies;
  std::vector<ScalarRun> runs, row_runs;
  std::uint64_t panel_size = 0, update_size = 0;  // the numbers of values in the arena
  std::uint64_t all_rows = 0;                     // the sum of the rows of all fronts
  std::uint32_t largest_front = 0, most_columns = 0, most_below = 0;
  double flops = 0;  // the operations of a factorization without added zeros

  std::uint32_t dim(std::uint32_t at) const { return offset[at + 1] - offset[at]; }
  /// The first row, in the front, of the block at position `at` ≥ front.first_block, or kNoParent if the
  /// front does not have this block. Takes O(log(blocks of the front)).
  std::uint32_t row_in(const Front& front, std::uint32_t at) const;

  std::span<const std::uint32_t> rows(const Front& f) const {
    return part(row_blocks, f.row_begin, f.row_end);
  }
  std::span<const std::uint32_t> children_of(const Front& f) const {
    return part(children, f.child_begin, f.child_end);
  }
  std::span<const BlockCopy> copies_of(const Front& f) const {
    return part(copies, f.copy_begin, f.copy_end);
  }
  std::span<const ScalarRun> pivot_runs(const Front& f) const { return part(runs, f.run_begin, f.run_split); }
  std::span<const ScalarRun> all_runs(const Front& f) const { return part(runs, f.run_begin, f.run_end); }
  std::span<const ScalarRun> row_runs_of(const Front& f) const {
    return part(row_runs, f.row_run_begin, f.row_run_end);
  }

 private:
  template <class T>
  static std::span<const T> part(const std::vector<T>& all, std::uint32_t begin, std::uint32_t end) {
    return std::span<const T>(all).subspan(begin, end - begin);
  }
};

/// The first part of the analysis. It needs little memory, even if the factor needs much memory.
struct FactorOutline {
  std::vector<std::uint32_t> order;  // the order before `partition`, which permutes it once more
  SupernodePartition partition;
  double flops = 0;
  Ordering ordering = Ordering::kMinimumDegree;  // the method that was chosen
};

/// Finds the elimination order and the supernodes. Uses `order` if it is not empty and `last` is empty, and
/// otherwise orders the blocks so that those in `last` come last. Throws InvalidArgument if `order` is
/// neither empty nor an order of all blocks, and Stopped when the token is raised.
FactorOutline outline_factor(const BlockStructure& structure, std::span<const std::uint32_t> last,
                             const AmalgamationRule& rule = {}, Ordering ordering = Ordering::kMinimumDegree,
                             int threads = 1, std::span<const std::uint32_t> order = {},
                             const StopToken& stop = {});
/// Computes all indices and the layout of the memory. Throws Stopped when the token is raised.
SymbolicFactor complete_factor(const BlockStructure& structure, const FactorOutline& outline,
                               const AmalgamationRule& rule = {}, int threads = 1,
                               const StopToken& stop = {});
/// Calls outline_factor() and complete_factor().
SymbolicFactor analyze_structure(const BlockStructure& structure, std::span<const std::uint32_t> last,
                                 const AmalgamationRule& rule = {}, int threads = 1,
                                 Ordering ordering = Ordering::kMinimumDegree);

}  // namespace boxplus
