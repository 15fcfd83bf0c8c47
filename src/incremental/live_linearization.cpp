// SPDX-License-Identifier: BSD-3-Clause
// The linearization of a LiveProblem: its queue of edges, and the linearization points of its vertices.
#include <algorithm>

#include "base/all_finite.h"
#include "base/paced_stop.h"
#include "incremental/live_problem.h"
#include "plan/dense_scratch.h"

namespace boxplus {

using Index = IncrementalFactor::Index;

/// Sets the linearization point of a block to the estimate of its vertex, and queues its edges.
void LiveProblem::set_point(std::uint32_t pool, std::uint32_t slot, Index block) {
  points_[pool]->copy_estimates({&slot, 1}, *graph_.vertex_pools()[pool]);
  factor_.reset_x(block);
  const auto fixed = graph_.vertex_pools()[pool]->fixed_directions(slot);
  std::vector<int> directions(fixed.begin(), fixed.end());
  for (const auto& [vertex, direction] : held_directions_) {
    if (vertex == vertex_of_[block]) directions.push_back(direction);
  }
  const bool is_same = std::ranges::equal(directions, factor_.held_scalars(block));
  if (!is_same) factor_.hold_scalars(block, directions);
  if (!is_same && (!held_.empty() || !held_directions_.empty())) may_be_anchored_ = true;
  for (const Index term : factor_.terms_of(block)) queue(edge_of_[term]);
}

void LiveProblem::queue(EdgeName name) {
  EdgeEntry& entry = edges_[name.pool][name.slot];
  if (entry.is_queued) return;
  entry.is_queued = true;
  queued_[name.pool].push_back(name.slot);
}

bool LiveProblem::has_queued_edges() const {
  return std::any_of(queued_.begin(), queued_.end(), [](const auto& list) { return !list.empty(); });
}

/// Lists the vertices of the queued edges whose estimates are not their linearization points.
void LiveProblem::list_points() {
  for (SlotList& list : lists_) list.slots.clear();
  ++pass_;
  pass_of_.resize(vertex_of_.size());
  for (std::uint32_t p = 0; p < queued_.size(); ++p) {
    for (const std::uint32_t edge : queued_[p]) {
      if (edges_[p][edge].term == kNone) continue;
      for (const Index block : factor_.blocks_of(edges_[p][edge].term)) {
        if (pass_of_[block] == pass_) continue;
        pass_of_[block] = pass_;
        const auto x = factor_.x(block);
        if (std::any_of(x.begin(), x.end(), [](double value) { return value != 0; }))
          lists_[vertex_of_[block].pool].slots.push_back(vertex_of_[block].slot);
      }
    }
  }
}

void LiveProblem::swap_points() {
  for (std::size_t p = 0; p < lists_.size(); ++p) {
    if (!lists_[p].slots.empty()) graph_.vertex_pools()[p]->swap_estimates(lists_[p].slots, *points_[p]);
  }
}

LiveProblem::Linearized LiveProblem::linearize(const StopToken& stop, std::uint32_t& count) {
  list_points();
  struct AtPoints {
    explicit AtPoints(LiveProblem& p) : problem(p) { problem.swap_points(); }
    ~AtPoints() { problem.swap_points(); }
    LiveProblem& problem;
  };
  const AtPoints at_points(*this);
  for (std::uint32_t p = 0; p < queued_.size(); ++p) {
    std::vector<std::uint32_t>& list = queued_[p];
    std::erase_if(list, [&](std::uint32_t edge) {
      edges_[p][edge].is_queued = edges_[p][edge].term != kNone;
      return !edges_[p][edge].is_queued;
    });
    if (list.empty()) continue;
    if (const Linearized result = linearize_pool(p, stop); result != Linearized::kAll) return result;
    count += static_cast<std::uint32_t>(list.size());
    for (const std::uint32_t edge : list) edges_[p][edge].is_queued = false;
    list.clear();
  }
  return Linearized::kAll;
}

/// Linearizes the queued edges of a pool.
LiveProblem::Linearized LiveProblem::linearize_pool(std::uint32_t p, const StopToken& stop) {
  const detail::EdgePool& pool = *graph_.edge_pools()[p];
  std::vector<std::uint32_t>& list = queued_[p];
  std::sort(list.begin(), list.end());
  scatter_.pool = p;
  scatter_.edges.assign(list.begin(), list.end());
  scatter_.targets.clear();
  scatter_.target_start.clear();
  for (const std::uint32_t edge : list) {
    scatter_.target_start.push_back(static_cast<std::uint32_t>(scatter_.targets.size()));
    place(pool, edge, edges_[p][edge].term);
  }
  reserve_memory(pool, list);
  PacedStop pace(stop, detail::EdgeTile::kCapacity);
  double* const values = factor_.values();
  if (!linearizer_.add(scatter_, 0, static_cast<std::uint32_t>(list.size()), *memory_,
                       {options_.numeric_jacobians, false}, pace, {values, values}))
    return Linearized::kStopped;
  for (const std::uint32_t edge : list) {
    clear_fixed(edges_[p][edge].term);
    if (all_finite(factor_.values_of(edges_[p][edge].term))) continue;
    non_finite_ = {p, edge, pool.generation(edge)};
    return Linearized::kNonFinite;
  }
  return Linearized::kAll;
}

/// Clears the term of an edge, and appends the targets of the edge to the scatter.
void LiveProblem::place(const detail::EdgePool& pool, std::uint32_t edge, Index term) {
  factor_.clear_term(term);
  const auto blocks = factor_.blocks_of(term);
  const auto slots = pool.vertex_slots(edge);
  members_.clear();  // the place of each vertex among the blocks of the term
  std::uint32_t next = 0;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const bool moves = next < blocks.size() &&
                       vertices_[pool.vertex_pool(edge, static_cast<int>(i))][slots[i]].block == blocks[next];
    members_.push_back(moves ? next++ : kNone);
  }
  for (const std::uint32_t i : members_)
    scatter_.targets.push_back(i == kNone ? Scatter::kNowhere : factor_.gradient_of(term, i));
  for (std::size_t i = 0; i < members_.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const bool moves = members_[i] != kNone && members_[j] != kNone;
      scatter_.targets.push_back(moves ? factor_.block_of(term, members_[i], members_[j])
                                       : Scatter::kNowhere);
    }
  }
}

/// Clears the rows and columns of a term that belong to fixed directions.
void LiveProblem::clear_fixed(Index term) {
  const auto blocks = factor_.blocks_of(term);
  double* const values = factor_.values();
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const std::uint32_t dim = factor_.dim(blocks[k]);
    for (const int held : factor_.held_scalars(blocks[k])) {
      const auto h = static_cast<std::uint32_t>(held);
      values[factor_.gradient_of(term, k) + h] = 0;
      for (std::size_t other = 0; other < blocks.size(); ++other) {
        const std::uint32_t size = factor_.dim(blocks[other]);
        if (other >= k) {  // the block (other, k), where h is a column
          std::fill_n(values + factor_.block_of(term, other, k) + h * size, size, 0.0);
        }
        if (other <= k) {  // the block (k, other), where h is a row
          double* const block = values + factor_.block_of(term, k, other);
          for (std::uint32_t c = 0; c < size; ++c) block[c * dim + h] = 0;
        }
      }
    }
  }
}

void LiveProblem::reserve_memory(const detail::EdgePool& pool, std::span<const std::uint32_t> edges) {
  bool grows = !memory_;
  for (const std::uint32_t edge : edges) {
    const detail::EdgeShape shape = pool.shape(edge);
    const auto capacity = static_cast<std::size_t>(pool.uniform_shape() ? tile_capacity(shape) : 1);
    const auto rows = static_cast<std::size_t>(std::max(1, shape.rows));
    const auto fit = [&](std::size_t& room, std::size_t needed) {
      grows = grows || needed > room;
      room = std::max(room, needed);
    };
    fit(memory_values_, capacity * rows * static_cast<std::size_t>(shape.cols));
    fit(memory_rows_, capacity * rows);
    fit(memory_dense_, dense_scratch(shape.rows, shape.cols));
    if (pool.uniform_shape()) break;
  }
  if (grows) memory_ = std::make_unique<TileMemory>(memory_values_, memory_rows_, memory_dense_);
}

}  // namespace boxplus
