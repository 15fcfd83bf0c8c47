// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <string>

#include "base/paced_stop.h"
#include "boxplus/base/error.h"
#include "linear/block_cholesky/factor_memory.h"
#include "linear/block_cholesky/front_runs.h"
#include "linear/block_cholesky/symbolic_factor.h"
#include "linear/ordering/amd_ordering.h"
#include "linear/ordering/nested_dissection.h"

namespace boxplus {
namespace {

template <class T>
std::uint32_t size_of(const std::vector<T>& v) {
  return static_cast<std::uint32_t>(v.size());
}

std::vector<std::uint32_t> composed(const std::vector<std::uint32_t>& order,
                                    const std::vector<std::uint32_t>& sequence) {
  std::vector<std::uint32_t> result;
  result.reserve(sequence.size());
  for (const std::uint32_t k : sequence) result.push_back(order[k]);
  return result;
}

/// Renumbers the nodes of a tree. Node k of the result is node sequence[k] of `tree`. If children come before
/// their parents in the sequence, the result is the elimination tree of the reordered matrix (Liu 1990).
std::vector<std::uint32_t> renumbered(const std::vector<std::uint32_t>& tree,
                                      const std::vector<std::uint32_t>& sequence) {
  std::vector<std::uint32_t> number(tree.size()), parent(tree.size(), kNoParent);
  for (std::uint32_t k = 0; k < sequence.size(); ++k) number[sequence[k]] = k;
  for (std::uint32_t k = 0; k < sequence.size(); ++k) {
    if (tree[sequence[k]] != kNoParent) parent[k] = number[tree[sequence[k]]];
  }
  return parent;
}

std::vector<std::uint32_t> dims_in(const BlockStructure& structure, const std::vector<std::uint32_t>& order) {
  std::vector<std::uint32_t> dims;
  dims.reserve(order.size());
  for (const std::uint32_t block : order) dims.push_back(structure.dim(block));
  return dims;
}

/// Counts (1 + l)² operations for each scalar column with l entries below the diagonal.
double count_flops(const ColumnCounts& counts, const std::vector<std::uint32_t>& dims) {
  double flops = 0;
  for (std::size_t j = 0; j < dims.size(); ++j) {
    for (std::uint32_t i = 1; i <= dims[j]; ++i) {
      const double length = counts.scalars[j] + double{0} + i;
      flops += length * length;
    }
  }
  return flops;
}

/// Fills a SymbolicFactor front by front.
class Builder {
 public:
  Builder(const BlockStructure& structure, SymbolicFactor& factor, const StopToken& stop)
      : structure_(structure),
        f_(factor),
        pace_(stop),
        local_(structure.blocks(), 0),
        mark_(structure.blocks(), kNoParent) {}

  void build(const SupernodePartition& partition, const AmalgamationRule& rule, int threads) {
    number_scalars(partition);
    list_entries_by_column();
    const std::uint32_t count = size_of(partition.start) - 1;
    f_.fronts.reserve(count);
    f_.copies.reserve(structure_.nonzero_blocks());
    std::vector<std::uint32_t> first_child(count, kNoParent), sibling(count, kNoParent);
    for (std::uint32_t s = 0; s < count; ++s) {
      pace_.step();
      Front front{partition.start[s], partition.start[s + 1], 0, 0, 0};
      front.child_begin = size_of(f_.children);
      for (std::uint32_t c = first_child[s]; c != kNoParent; c = sibling[c]) f_.children.push_back(c);
      front.child_end = size_of(f_.children);
      std::sort(f_.children.begin() + front.child_begin, f_.children.end());
      find_rows(front, s);
      place_blocks(front);
      for (const std::uint32_t c : f_.children_of(front)) {
        find_runs(f_, f_.fronts[c], front, [&](std::uint32_t row) {
          pace_.step();
          return local_[row];
        });
      }
      if (front.row_end > front.row_begin) {
        front.parent = f_.front_of[f_.row_blocks[front.row_begin]];
        sibling[s] = first_child[front.parent];
        first_child[front.parent] = s;
      }
      f_.fronts.push_back(front);
    }
    pace_.step(static_cast<std::int64_t>(f_.fronts.size()));
    f_.schedule = make_schedule(f_.fronts, rule, threads);
    assign_memory(f_, pace_);
  }

 private:
  std::uint32_t dim(std::uint32_t position) const { return f_.dim(position); }

  void number_scalars(const SupernodePartition& partition) {
    f_.position.resize(f_.order.size());
    f_.offset.assign(1, 0);
    for (std::uint32_t k = 0; k < f_.order.size(); ++k) {
      pace_.step();
      f_.position[f_.order[k]] = k;
      f_.offset.push_back(f_.offset.back() + structure_.dim(f_.order[k]));
    }
    f_.front_of.resize(f_.order.size());
    for (std::uint32_t s = 0; s + 1 < partition.start.size(); ++s) {
      std::fill(f_.front_of.begin() + partition.start[s], f_.front_of.begin() + partition.start[s + 1], s);
    }
  }

  /// Sorts the blocks of A by the position of their column in the lower triangle of the permuted matrix.
  void list_entries_by_column() {
    entry_start_.assign(structure_.blocks() + 1, 0);
    const auto for_each = [&](auto visit) {
      for (std::uint32_t j = 0; j < structure_.blocks(); ++j) {
        for (std::uint32_t k = structure_.column_start[j]; k < structure_.column_start[j + 1]; ++k) {
          pace_.step();
          const auto [low, high] = std::minmax(f_.position[j], f_.position[structure_.row[k]]);
          visit(low, Entry{high, k, f_.position[j] != low});
        }
      }
    };
    for_each([&](std::uint32_t column, const Entry&) { ++entry_start_[column + 1]; });
    for (std::uint32_t j = 0; j < structure_.blocks(); ++j) entry_start_[j + 1] += entry_start_[j];
    std::vector<std::uint32_t> next(entry_start_.begin(), entry_start_.end() - 1);
    entries_.resize(structure_.nonzero_blocks());
    for_each([&](std::uint32_t column, const Entry& entry) { entries_[next[column]++] = entry; });
  }

  /// Finds the rows below the front's columns. They are the union of the rows of A in these columns and the
  /// rows of the front's children.
  void find_rows(Front& front, std::uint32_t s) {
    front.row_begin = size_of(f_.row_blocks);
    const auto add = [&](std::uint32_t row) {
      pace_.step();
      if (row < front.end_block || mark_[row] == s) return;
      mark_[row] = s;
      f_.row_blocks.push_back(row);
    };
    for (std::uint32_t j = front.first_block; j < front.end_block; ++j) {
      for (std::uint32_t e = entry_start_[j]; e < entry_start_[j + 1]; ++e) add(entries_[e].row);
    }
    for (const std::uint32_t c : f_.children_of(front)) {
      for (std::uint32_t k = f_.fronts[c].row_begin; k < f_.fronts[c].row_end; ++k) add(f_.row_blocks[k]);
    }
    front.row_end = size_of(f_.row_blocks);
    std::sort(f_.row_blocks.begin() + front.row_begin, f_.row_blocks.end());
    for (std::uint32_t j = front.first_block; j < front.end_block; ++j) {
      local_[j] = f_.offset[j] - f_.offset[front.first_block];
    }
    front.columns = f_.offset[front.end_block] - f_.offset[front.first_block];
    front.row_run_begin = size_of(f_.row_runs);
    for (const std::uint32_t row : f_.rows(front)) {
      local_[row] = front.columns + front.below;
      f_.row_offsets.push_back(local_[row]);
      append_run(f_.row_runs, front.row_run_begin, {front.below, f_.offset[row], dim(row)});
      front.below += dim(row);
    }
    front.row_run_end = size_of(f_.row_runs);
    front.leading = choose_leading(front.rows());
  }

  void place_blocks(Front& front) {
    front.copy_begin = size_of(f_.copies);
    for (std::uint32_t j = front.first_block; j < front.end_block; ++j) {
      for (std::uint32_t e = entry_start_[j]; e < entry_start_[j + 1]; ++e) {
        pace_.step();
        const Entry& entry = entries_[e];
        const std::uint32_t rows = entry.transposed ? dim(j) : dim(entry.row);
        const std::uint32_t columns = entry.transposed ? dim(entry.row) : dim(j);
        f_.copies.push_back({structure_.value_start[entry.index],
                             local_[entry.row] + local_[j] * front.leading, rows, columns, entry.transposed});
      }
    }
    front.copy_end = size_of(f_.copies);
  }

  struct Entry {
    std::uint32_t row, index;
    bool transposed;
  };
  const BlockStructure& structure_;
  SymbolicFactor& f_;
  PacedStop pace_;
  std::vector<std::uint32_t> local_;  // the scalar offset of each position in the current front
  std::vector<std::uint32_t> mark_;
  std::vector<std::uint32_t> entry_start_;
  std::vector<Entry> entries_;
};

/// A postordered elimination order, and the cost of a factorization in this order.
struct Ordered {
  std::vector<std::uint32_t> order, parent, dims;
  ColumnCounts counts;
  double flops;

  Ordered(const BlockStructure& structure, const std::vector<std::uint32_t>& given, std::uint32_t keep,
          const StopToken& stop) {
    PacedStop pace(stop);
    const std::vector<std::uint32_t> tree = elimination_tree(UpperPattern(structure, given, stop), stop);
    pace.step(structure.blocks());
    const std::vector<std::uint32_t> sequence = postorder(tree, keep);
    order = composed(given, sequence);
    pace.step(structure.blocks());
    parent = renumbered(tree, sequence);
    pace.step(structure.blocks());
    const UpperPattern pattern(structure, order, stop);
    dims = dims_in(structure, order);
    counts = count_columns(pattern, parent, dims, stop);
    pace.step(structure.blocks());
    flops = count_flops(counts, dims);
  }
};

void check_order(std::span<const std::uint32_t> order, std::uint32_t blocks) {
  std::vector<bool> seen(blocks);
  for (const std::uint32_t block : order) {
    if (block < blocks) seen[block] = true;
  }
  if (order.size() != blocks || std::find(seen.begin(), seen.end(), false) != seen.end())
    throw InvalidArgument("block Cholesky: expected an elimination order of all " + std::to_string(blocks) +
                          " blocks");
}

/// The fraction of all pairs of blocks that A joins.
double density(const BlockStructure& structure) {
  const double blocks = structure.blocks();
  const double joined = static_cast<double>(structure.row.size()) - blocks;
  return 2 * joined / std::max(1.0, blocks * (blocks - 1));
}

/// The order by minimum degree. In a dense matrix, most rows may be dense rows, so AMD would leave them
/// without an order. Therefore, a dense matrix is ordered in both ways.
Ordered order_by_degree(const BlockStructure& structure, std::span<const std::uint32_t> last,
                        std::uint32_t keep, const StopToken& stop) {
  constexpr double kDense = 0.125;
  Ordered best(structure, amd_ordering(structure, last, stop), keep, stop);
  if (density(structure) < kDense) return best;
  Ordered other(structure, amd_ordering(structure, last, stop, DenseRows::kOrdered), keep, stop);
  if (other.flops < best.flops) return other;
  return best;
}

/// Whether nested dissection is predicted to save more time than it takes. If nested dissection is better
/// than minimum degree, it typically saves a fifth to a third of the operations of a sparse A. Times are in
/// nanoseconds.
///
/// If two parts with the fractions a and b of all n blocks are separated, A lacks their ab n² pairs. So the
/// more of all n²/2 pairs A has, the less can be separated. Photo collections have 0.4 of them, and nested
/// dissection then saves nothing; of 1500 cameras in a city, which have 0.04, it saves 11 %.
bool dissection_pays(const BlockStructure& structure, double flops, const AmalgamationRule& rule) {
  constexpr double kFactorizations = 8, kSaving = 0.2, kPerEntry = 500, kDense = 0.4;
  const double saving = kSaving * (1 - density(structure) / kDense);
  const double blocks = structure.blocks(), entries = static_cast<double>(structure.row.size());
  const double levels = std::log2(std::max(2.0, blocks / 100));
  return kFactorizations * saving * rule.per_flop * flops > kPerEntry * entries * levels;
}

}  // namespace

FactorOutline outline_factor(const BlockStructure& structure, std::span<const std::uint32_t> last,
                             const AmalgamationRule& rule, Ordering ordering, int threads,
                             std::span<const std::uint32_t> order, const StopToken& stop) {
  const auto keep = static_cast<std::uint32_t>(last.size());
  const auto outline = [&](const Ordered& best, Ordering taken) {
    return FactorOutline{best.order, partition_columns(best.parent, best.counts, best.dims, keep, rule, stop),
                         best.flops, taken};
  };
  if (!order.empty() && last.empty()) {
    check_order(order, structure.blocks());
    return outline({structure, {order.begin(), order.end()}, keep, stop}, ordering);
  }
  if (ordering == Ordering::kNestedDissection)
    return outline({structure, nested_dissection(structure, last, threads, stop), keep, stop},
                   Ordering::kNestedDissection);
  const Ordered by_degree = order_by_degree(structure, last, keep, stop);
  if (ordering == Ordering::kAutomatic && dissection_pays(structure, by_degree.flops, rule)) {
    const Ordered dissected(structure, nested_dissection(structure, last, threads, stop), keep, stop);
    if (dissected.flops < by_degree.flops) return outline(dissected, Ordering::kNestedDissection);
  }
  return outline(by_degree, Ordering::kMinimumDegree);
}

SymbolicFactor complete_factor(const BlockStructure& structure, const FactorOutline& outline,
                               const AmalgamationRule& rule, int threads, const StopToken& stop) {
  SymbolicFactor factor;
  factor.order = composed(outline.order, outline.partition.order);
  factor.flops = outline.flops;
  Builder(structure, factor, stop).build(outline.partition, rule, threads);
  return factor;
}

SymbolicFactor analyze_structure(const BlockStructure& structure, std::span<const std::uint32_t> last,
                                 const AmalgamationRule& rule, int threads, Ordering ordering) {
  return complete_factor(structure, outline_factor(structure, last, rule, ordering, threads), rule, threads);
}

}  // namespace boxplus
