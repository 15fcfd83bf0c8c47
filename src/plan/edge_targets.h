// SPDX-License-Identifier: BSD-3-Clause
// The places in H and in the gradient to which an edge adds.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "plan/plan.h"

namespace boxplus {

inline constexpr std::uint32_t kNoBlock = BlockStructure::kAbsent;

/// The block of each slot of each vertex pool, or kNoBlock.
using BlockOf = std::vector<std::vector<std::uint32_t>>;

/// Lists the blocks of an edge's vertices, in order. Lists kNoBlock for vertices that do not move.
inline void edge_blocks(const detail::EdgePool& pool, std::uint32_t edge, const BlockOf& block_of,
                        std::vector<std::uint32_t>& out) {
  out.clear();
  const auto slots = pool.vertex_slots(edge);
  for (std::size_t i = 0; i < slots.size(); ++i) {
    out.push_back(block_of[pool.vertex_pool(edge, static_cast<int>(i))][slots[i]]);
  }
}

inline bool owns(const Chunk& chunk, std::uint32_t block) {
  return block != kNoBlock && block >= chunk.first_column && block < chunk.last_column;
}

/// Whether an edge belongs to the chunk. `blocks` lists the blocks of the edge's vertices.
inline bool touches(const Chunk& chunk, const std::vector<std::uint32_t>& blocks) {
  if (chunk.first_shared != kNoBlock) return owns(chunk, *std::min_element(blocks.begin(), blocks.end()));
  return std::any_of(blocks.begin(), blocks.end(), [&](std::uint32_t b) { return owns(chunk, b); });
}

/// The distances modulo 2^32 from a value of H to its place among the values of the Linearizer: for columns
/// that the chunk owns, and for columns that all chunks share.
struct ValueShift {
  std::uint32_t own = 0, shared = 0;
};

/// Appends `edge` to `scatter`, which belongs to `chunk`. `blocks` lists the blocks of the edge's vertices.
void append_edge(const detail::EdgePool& pool, std::uint32_t edge, const std::vector<std::uint32_t>& blocks,
                 const BlockStructure& structure, const Chunk& chunk, ValueShift shift, Scatter& scatter);

}  // namespace boxplus
