// SPDX-License-Identifier: BSD-3-Clause
#include "linear/ordering/nested_dissection.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/paced_stop.h"
#include "boxplus/base/parallel.h"
#include "linear/ordering/amd_ordering.h"
#include "linear/ordering/vertex_separator.h"

namespace boxplus {
namespace {

constexpr std::uint32_t kLeaf = 200;  // the largest number of blocks of a piece that is not divided
constexpr std::uint32_t kAbsent = 0xFFFFFFFFu;

/// The graph of the blocks that are not in `last`, weighted by their sizes. `block_of` receives the block of
/// each vertex.
WeightedGraph graph_of(const BlockStructure& structure, std::span<const std::uint32_t> last,
                       std::vector<std::uint32_t>& block_of, const StopToken& stop) {
  PacedStop pace(stop);
  const std::vector<int> vertex = number_free_blocks(structure, last);
  for (std::uint32_t block = 0; block < structure.blocks(); ++block) {
    if (vertex[block] != kIsLast) block_of.push_back(block);
  }
  WeightedGraph graph;
  std::vector<std::uint32_t> degree(block_of.size() + 1, 0);
  const auto for_each_edge = [&](auto&& f) {
    for (const std::uint32_t j : block_of) {
      for (std::uint32_t k = structure.column_start[j] + 1; k < structure.column_start[j + 1]; ++k) {
        pace.step();
        if (vertex[structure.row[k]] == kIsLast) continue;
        const auto a = static_cast<std::uint32_t>(vertex[j]);
        const auto b = static_cast<std::uint32_t>(vertex[structure.row[k]]);
        f(a, b);
        f(b, a);
      }
    }
  };
  for_each_edge([&](std::uint32_t a, std::uint32_t) { ++degree[a]; });
  for (std::size_t v = 0; v < block_of.size(); ++v) graph.start.push_back(graph.start.back() + degree[v]);
  graph.neighbor.resize(graph.start.back());
  graph.edge_weight.assign(graph.start.back(), 1);
  std::vector<std::uint32_t> next(graph.start.begin(), graph.start.end() - 1);
  for_each_edge([&](std::uint32_t a, std::uint32_t b) { graph.neighbor[next[a]++] = b; });
  for (const std::uint32_t block : block_of) graph.weight.push_back(structure.dim(block));
  return graph;
}

/// Returns the part of `graph` on the side `wanted`. `part_block_of` receives the block of each vertex of
/// this part.
WeightedGraph part_of(const WeightedGraph& graph, const std::vector<Side>& side, Side wanted,
                      const std::vector<std::uint32_t>& block_of, std::vector<std::uint32_t>& part_block_of,
                      PacedStop& pace) {
  std::vector<std::uint32_t> vertex(graph.vertices(), kAbsent);
  std::uint32_t count = 0;
  for (std::uint32_t v = 0; v < graph.vertices(); ++v) {
    if (side[v] == wanted) vertex[v] = count++;
  }
  WeightedGraph part;
  for (std::uint32_t v = 0; v < graph.vertices(); ++v) {
    if (side[v] != wanted) continue;
    for (const std::uint32_t u : graph.neighbors(v)) {
      pace.step();
      if (vertex[u] == kAbsent) continue;
      part.neighbor.push_back(vertex[u]);
      part.edge_weight.push_back(1);
    }
    part.start.push_back(static_cast<std::uint32_t>(part.neighbor.size()));
    part.weight.push_back(graph.weight[v]);
    part_block_of.push_back(block_of[v]);
  }
  return part;
}

/// A part of the graph, its separator, and the parts into which the separator divides it.
struct Piece {
  WeightedGraph graph;
  std::vector<std::uint32_t> block_of;
  std::vector<std::uint32_t> separator;  // the blocks of the separator; empty if the piece is not divided
  std::vector<Piece> parts;
};

void part(Piece& piece, const StopToken& stop) {
  const WeightedGraph& graph = piece.graph;
  if (graph.vertices() <= kLeaf) return;
  const std::vector<Side> side = find_separator(graph, stop);
  const auto count = [&](Side wanted) { return std::count(side.begin(), side.end(), wanted); };
  if (count(kLeft) == 0 || count(kRight) == 0) return;
  PacedStop pace(stop);
  for (const Side wanted : {kLeft, kRight}) {
    Piece& half = piece.parts.emplace_back();
    half.graph = part_of(graph, side, wanted, piece.block_of, half.block_of, pace);
  }
  for (std::uint32_t v = 0; v < graph.vertices(); ++v) {
    if (side[v] == kSeparator) piece.separator.push_back(piece.block_of[v]);
  }
}

/// All separators, level by level. The separator of a piece comes before the separators of its parts. Divides
/// the pieces of one level in parallel.
std::vector<std::vector<std::uint32_t>> find_separators(Piece whole, int threads, const StopToken& stop) {
  std::vector<std::vector<std::uint32_t>> separators;
  std::vector<Piece> level;
  level.push_back(std::move(whole));
  while (!level.empty()) {
    const std::size_t tasks = std::min(level.size(), static_cast<std::size_t>(std::max(1, threads)));
    detail::parallel_tasks(static_cast<int>(tasks), [&](int task) {
      for (auto k = static_cast<std::size_t>(task); k < level.size(); k += tasks) part(level[k], stop);
    });
    std::vector<Piece> next;
    for (Piece& piece : level) {
      if (!piece.separator.empty()) separators.push_back(std::move(piece.separator));
      std::move(piece.parts.begin(), piece.parts.end(), std::back_inserter(next));
    }
    level = std::move(next);
  }
  return separators;
}

}  // namespace

std::vector<std::uint32_t> nested_dissection(const BlockStructure& structure,
                                             std::span<const std::uint32_t> last, int threads,
                                             const StopToken& stop) {
  Piece whole;
  whole.graph = graph_of(structure, last, whole.block_of, stop);
  const auto separators = find_separators(std::move(whole), threads, stop);
  std::vector<int> rank_of(structure.blocks(), 0);  // blocks that are in no separator come first
  int rank = 0;
  for (auto separator = separators.rbegin(); separator != separators.rend(); ++separator) {
    ++rank;
    for (const std::uint32_t block : *separator) rank_of[block] = rank;
  }
  for (const std::uint32_t block : last) rank_of[block] = ++rank;
  return constrained_amd_ordering(structure, rank_of, stop);
}

}  // namespace boxplus
