// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/scene/pattern.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <span>

#include "boxplus/base/error.h"
#include "linear/block_cholesky/elimination_tree.h"
#include "linear/ordering/amd_ordering.h"
#include "plan/plan.h"

namespace boxplus::viewer {
namespace {

/// Draws H and L in one order of the blocks.
class PatternMaker {
 public:
  PatternMaker(const BlockStructure& structure, std::span<const std::uint32_t> order, std::uint32_t cells,
               const StopToken& stop)
      : upper_(structure, order, stop), cells_(cells), stop_(stop) {}

  PatternPicture H() const {
    PatternPicture picture = empty();
    for (std::uint32_t row = 0; row < upper_.columns(); ++row) {
      add(picture, row, row);
      for (const std::uint32_t column : upper_.rows(row)) add(picture, row, column);
    }
    return picture;
  }

  /// The blocks in a row of L are those on the paths in the elimination tree from the blocks of H in this row
  /// up to the row (Liu 1990, section 5).
  PatternPicture L() const {
    const std::vector<std::uint32_t> parent = elimination_tree(upper_, stop_);
    std::vector<std::uint32_t> last_row(upper_.columns(), kNoParent);
    PatternPicture picture = empty();
    for (std::uint32_t row = 0; row < upper_.columns(); ++row) {
      stop_.check();
      if (picture.blocks > Pattern::kMostBlocks) {
        picture.is_complete = false;
        break;
      }
      last_row[row] = row;
      add(picture, row, row);
      for (std::uint32_t column : upper_.rows(row)) {
        for (; last_row[column] != row; column = parent[column]) {
          last_row[column] = row;
          add(picture, row, column);
        }
      }
    }
    return picture;
  }

 private:
  PatternPicture empty() const {
    return {.counts = std::vector<std::uint32_t>(std::size_t{cells_} * cells_)};
  }

  std::size_t cell_of(std::uint32_t block) const { return std::size_t{block} * cells_ / upper_.columns(); }

  void add(PatternPicture& picture, std::uint32_t row, std::uint32_t column) const {
    ++picture.blocks;
    ++picture.counts[cell_of(row) * cells_ + cell_of(column)];
  }

  UpperPattern upper_;
  std::uint32_t cells_;
  const StopToken& stop_;
};

}  // namespace

Pattern read_pattern(const Graph& graph, const StopToken& stop) {
  const Plan plan = make_plan(graph, {.stop = stop});
  Pattern pattern;
  pattern.size = plan.structure.blocks();
  if (pattern.size > Pattern::kMostSize) {
    throw InvalidArgument(fmt::format("expected at most {} vertices that move for a picture of H, got {}",
                                      Pattern::kMostSize, pattern.size));
  }
  pattern.cells = std::min(pattern.size, Pattern::kMostCells);

  std::vector<std::uint32_t> by_id(pattern.size);
  std::iota(by_id.begin(), by_id.end(), 0U);
  std::stable_sort(by_id.begin(), by_id.end(), [&](std::uint32_t a, std::uint32_t b) {
    return graph.id(plan.block_vertex[a]) < graph.id(plan.block_vertex[b]);
  });
  const PatternMaker natural(plan.structure, by_id, pattern.cells, stop);
  pattern.H_by_id = natural.H();
  pattern.L_by_id = natural.L();
  const PatternMaker ordered(plan.structure, amd_ordering(plan.structure, {}, stop), pattern.cells, stop);
  pattern.H_ordered = ordered.H();
  pattern.L_ordered = ordered.L();
  return pattern;
}

}  // namespace boxplus::viewer
