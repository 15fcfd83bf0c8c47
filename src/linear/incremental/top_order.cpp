// SPDX-License-Identifier: BSD-3-Clause
#include "linear/incremental/top_order.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "linear/ordering/amd_ordering.h"

namespace boxplus {
namespace {

/// The graph of a matrix as rows of bits, in which nodes are eliminated.
class BitGraph {
 public:
  explicit BitGraph(const BlockStructure& structure)
      : structure_(structure),
        count_(structure.blocks()),
        words_((count_ + 63) / 64),
        bits_(count_ * words_) {
    for (std::uint32_t j = 0; j < count_; ++j) {
      for (std::uint32_t e = structure.column_start[j] + 1; e < structure.column_start[j + 1]; ++e) {
        set(j, structure.row[e]);
        set(structure.row[e], j);
      }
    }
  }

  struct Order {
    std::vector<std::uint32_t> blocks;
    double flops = 0;
  };
  /// Eliminates the oldest of the nodes whose degree is at most the minimum plus `slack`, again and again;
  /// the last node is the last one. Ends early if the operations exceed `limit`.
  Order eliminate(std::uint32_t slack, double limit) {
    Order order;
    std::vector<std::uint64_t> graph = bits_;
    std::vector<std::uint32_t> degree(count_), left(count_);
    for (std::uint32_t k = 0; k < count_; ++k) {
      degree[k] = count_of(row(graph, k));
      left[k] = k;
    }
    while (!left.empty() && order.flops < limit) {
      const auto end = left.size() > 1 ? left.end() - 1 : left.end();
      std::uint32_t least = std::numeric_limits<std::uint32_t>::max();
      for (auto k = left.begin(); k != end; ++k) least = std::min(least, degree[*k]);
      const auto chosen =
          std::find_if(left.begin(), end, [&](std::uint32_t k) { return degree[k] <= least + slack; });
      const std::uint32_t node = *chosen;
      left.erase(chosen);
      order.blocks.push_back(node);
      const std::uint64_t* const own = row(graph, node);
      double below = 0;
      for_each_bit(own, [&](std::uint32_t k) { below += structure_.dim(k); });
      const double dim = structure_.dim(node);
      order.flops += ((below + dim) * (below + dim) * (below + dim) - below * below * below) / 3;
      for_each_bit(own, [&](std::uint32_t k) {
        std::uint64_t* const other = row(graph, k);
        for (std::uint32_t w = 0; w < words_; ++w) other[w] |= own[w];
        other[k / 64] &= ~(std::uint64_t{1} << k % 64);
        other[node / 64] &= ~(std::uint64_t{1} << node % 64);
        degree[k] = count_of(other);
      });
    }
    return order;
  }

 private:
  void set(std::uint32_t i, std::uint32_t j) { bits_[i * words_ + j / 64] |= std::uint64_t{1} << j % 64; }
  std::uint64_t* row(std::vector<std::uint64_t>& graph, std::uint32_t k) const {
    return graph.data() + k * words_;
  }
  std::uint32_t count_of(const std::uint64_t* words) const {
    std::uint64_t count = 0;
    for (std::uint32_t w = 0; w < words_; ++w) count += ones(words[w]);
    return static_cast<std::uint32_t>(count);
  }
  /// std::popcount() without the call of a function on processors that have no instruction for it.
  static std::uint64_t ones(std::uint64_t word) {
    word -= (word >> 1) & 0x5555555555555555u;
    word = (word & 0x3333333333333333u) + ((word >> 2) & 0x3333333333333333u);
    return ((word + (word >> 4)) & 0x0F0F0F0F0F0F0F0Fu) * 0x0101010101010101u >> 56;
  }
  template <class F>
  void for_each_bit(const std::uint64_t* words, F&& f) const {
    for (std::uint32_t w = 0; w < words_; ++w) {
      for (std::uint64_t word = words[w]; word != 0; word &= word - 1)
        f(w * 64 + static_cast<std::uint32_t>(std::countr_zero(word)));
    }
  }

  const BlockStructure& structure_;
  std::size_t count_, words_;
  std::vector<std::uint64_t> bits_;
};

}  // namespace

std::vector<std::uint32_t> order_top(const BlockStructure& structure) {
  constexpr std::uint32_t kMost = 1024;
  if (structure.blocks() > kMost) {
    const std::uint32_t last = structure.blocks() - 1;
    return amd_ordering(structure, std::span(&last, 1));
  }
  BitGraph graph(structure);
  BitGraph::Order best = graph.eliminate(0, std::numeric_limits<double>::infinity());
  constexpr std::uint32_t kSlack = 4, kByAge = kMost;
  for (const std::uint32_t slack : {kSlack, kByAge}) {
    BitGraph::Order other = graph.eliminate(slack, best.flops);
    if (other.flops < best.flops) best = std::move(other);
  }
  return best.blocks;
}

}  // namespace boxplus
