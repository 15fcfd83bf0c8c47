// SPDX-License-Identifier: BSD-3-Clause
#include "plan/edge_targets.h"

namespace boxplus {
namespace {

/// Whether all chunks add to the column of this block.
bool is_shared(const Chunk& chunk, std::uint32_t block) {
  return block != kNoBlock && block >= chunk.first_shared;
}

std::uint32_t target(const BlockStructure& structure, const Chunk& chunk, ValueShift shift, std::uint32_t i,
                     std::uint32_t j) {
  if (i == kNoBlock || j == kNoBlock) return Scatter::kNowhere;
  const std::uint32_t column = std::min(i, j);
  const bool shared = is_shared(chunk, column);
  if (!shared && !owns(chunk, column)) return Scatter::kNowhere;
  const std::uint32_t value =
      structure.value_start[structure.find(std::max(i, j), column)] + (shared ? shift.shared : shift.own);
  return i >= j ? value : value | Scatter::kTransposed;
}

std::uint32_t gradient_target(const BlockStructure& structure, const Chunk& chunk, std::uint32_t block) {
  if (is_shared(chunk, block)) return structure.offset[block] + chunk.copy.in_gradient;
  return owns(chunk, block) ? structure.offset[block] : Scatter::kNowhere;
}

}  // namespace

void append_edge(const detail::EdgePool& pool, std::uint32_t edge, const std::vector<std::uint32_t>& blocks,
                 const BlockStructure& structure, const Chunk& chunk, ValueShift shift, Scatter& scatter) {
  scatter.edges.push_back(edge);
  if (!pool.uniform_shape())
    scatter.target_start.push_back(static_cast<std::uint32_t>(scatter.targets.size()));
  for (const std::uint32_t block : blocks) {
    scatter.targets.push_back(gradient_target(structure, chunk, block));
  }
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j)
      scatter.targets.push_back(target(structure, chunk, shift, blocks[i], blocks[j]));
  }
}

}  // namespace boxplus
