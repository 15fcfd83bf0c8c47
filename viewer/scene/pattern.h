// SPDX-License-Identifier: BSD-3-Clause
// Where H and its Cholesky factor L have blocks, as pictures of limited size.
#pragma once

#include <cstdint>
#include <vector>

#include "boxplus/base/stop_token.h"
#include "boxplus/graph/graph.h"

namespace boxplus::viewer {

/// The lower triangle of H, or the factor L, in cells that are squares of blocks.
struct PatternPicture {
  /// The number of blocks, diagonal included. If `is_complete` is false, there are more, and the picture has
  /// only the first rows.
  std::uint64_t blocks = 0;
  bool is_complete = true;
  std::vector<std::uint32_t> counts = {};  ///< the blocks in each cell, row by row
};

struct Pattern {
  std::uint32_t size = 0;   ///< the number of block rows: of the vertices that move
  std::uint32_t cells = 0;  ///< in each row and column of a picture: min(size, kMostCells)
  /// H and L with the vertices by their ids, and in an order that makes L sparse (approximate minimum
  /// degree).
  PatternPicture H_by_id, L_by_id, H_ordered, L_ordered;

  static constexpr std::uint32_t kMostCells = 512, kMostSize = 1'000'000;
  static constexpr std::uint64_t kMostBlocks = 100'000'000;
};

/// Takes O(edges log(edges)), plus the number of blocks of L, which kMostBlocks limits. Throws
/// InvalidArgument if more than kMostSize vertices move, and Stopped when the token is raised.
Pattern read_pattern(const Graph& graph, const StopToken& stop = {});

}  // namespace boxplus::viewer
