// SPDX-License-Identifier: BSD-3-Clause
#include "incremental/live_problem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "base/all_finite.h"
#include "base/paced_stop.h"
#include "boxplus/base/error.h"
#include "incremental/dense_marginal.h"
#include "incremental/marginal_pool.h"
#include "plan/dense_scratch.h"

namespace boxplus {
namespace {

using Index = IncrementalFactor::Index;

enum Kind : std::uint8_t { kLength, kAngle, kOther };

double distance_of(const TangentDistance& distance, std::uint8_t kind) {
  return kind == kLength ? distance.length : kind == kAngle ? distance.angle : distance.other;
}

/// Whether two frames differ by more than rounding: in their rotations, and in their translations.
std::array<bool, 2> differ(const detail::Frame& a, const detail::Frame& b, double bound) {
  const auto far_apart = [bound](double x, double y) { return std::abs(x - y) > bound; };
  const auto size = static_cast<std::ptrdiff_t>(a.dimension);
  const bool turned =
      a.has_rotation && !std::equal(a.rotation.begin(), a.rotation.begin() + size * size, b.rotation.begin(),
                                    [&](double x, double y) { return !far_apart(x, y); });
  const bool shifted = !std::equal(a.translation.begin(), a.translation.begin() + size, b.translation.begin(),
                                   [&](double x, double y) { return !far_apart(x, y); });
  return {turned, shifted};
}

}  // namespace

LiveProblem::LiveProblem(Graph& graph, const SmootherOptions& options, const std::set<EdgeRef>& aside)
    : graph_(graph), options_(options), aside_(aside), linearizer_(graph) {
  detail::ChangeLog all;
  for (std::uint32_t p = 0; p < graph.vertex_pools().size(); ++p) {
    const detail::VertexPool& pool = *graph.vertex_pools()[p];
    for (std::uint32_t slot = 0; slot < pool.slots(); ++slot) {
      if (pool.alive(slot)) all.vertices.push_back({p, slot, pool.generation(slot)});
    }
  }
  all.edges = graph.all_edges();
  apply(all);
}

// ---- The elements ----

void LiveProblem::grow() {
  const auto pools = graph_.vertex_pools();
  vertices_.resize(pools.size());
  kinds_.resize(pools.size());
  lists_.resize(pools.size());
  for (std::size_t p = 0; p < pools.size(); ++p) {
    vertices_[p].resize(pools[p]->slots());
    if (p < points_.size()) continue;
    points_.push_back(pools[p]->make_store());
    before_.push_back(pools[p]->make_store());
  }
  edges_.resize(graph_.edge_pools().size());
  queued_.resize(edges_.size());
  is_relative_.resize(edges_.size());
  for (std::size_t p = 0; p < edges_.size(); ++p) edges_[p].resize(graph_.edge_pools()[p]->slots());
}

void LiveProblem::apply(const detail::ChangeLog& log) {
  grow();
  ++applies_;
  for (const EdgeRef& edge : log.edges) drop_stale_edge(edge);
  again_.clear();
  for (const VertexRef& vertex : log.vertices) apply_vertex(vertex);
  for (const EdgeRef& edge : log.edges) apply_edge(edge);
  for (const EdgeRef& edge : again_) apply_edge(edge);
  for (const Index block : maybe_unused_) {
    const VertexRef vertex = vertex_of_[block];
    VertexEntry& entry = vertices_[vertex.pool][vertex.slot];
    if (entry.block == block && factor_.terms_of(block).empty()) remove_block(entry);
  }
  maybe_unused_.clear();
}

bool LiveProblem::hold(const Plan& plan) {
  std::vector<std::pair<VertexRef, int>> directions;
  for (const std::uint32_t scalar : plan.held_scalars) {
    const auto& offset = plan.structure.offset;
    const auto block = std::upper_bound(offset.begin(), offset.end(), scalar) - offset.begin() - 1;
    const auto k = static_cast<std::size_t>(block);
    directions.emplace_back(plan.block_vertex[k], static_cast<int>(scalar - offset[k]));
  }
  if (may_be_anchored_) {
    for (std::size_t p = 0; p < is_relative_.size(); ++p)
      is_relative_[p] = graph_.edge_pools()[p]->slots() > 0;
  }
  may_be_anchored_ = false;
  const bool is_same = directions == held_directions_ &&
                       std::equal(held_.begin(), held_.end(), plan.held.begin(), plan.held.end(),
                                  [](const auto& a, const auto& b) { return a.vertex == b.vertex; });
  if (is_same) return false;
  std::vector<VertexRef> changed;
  const auto hold_all = [&](const std::vector<detail::GaugeVertex>& list, bool is_held) {
    for (const detail::GaugeVertex& held : list) {
      if (!graph_.contains(held.vertex)) continue;
      vertices_[held.vertex.pool][held.vertex.slot].is_held = is_held;
      changed.push_back(held.vertex);
    }
  };
  hold_all(held_, false);
  hold_all(plan.held, true);
  directions.swap(held_directions_);
  for (const auto& [vertex, direction] : held_directions_) changed.push_back(vertex);
  for (const auto& [vertex, direction] : directions) {
    if (graph_.contains(vertex)) changed.push_back(vertex);
  }
  held_ = plan.held;
  again_.clear();
  for (const VertexRef& vertex : changed) apply_vertex(vertex);
  for (const EdgeRef& edge : again_) apply_edge(edge);
  return true;
}

/// Removes the term of a known edge if the edge is gone or takes no part any more.
void LiveProblem::drop_stale_edge(EdgeRef edge) {
  const detail::EdgePool& pool = *graph_.edge_pools()[edge.pool];
  const EdgeEntry& entry = edges_[edge.pool][edge.slot];
  if (entry.term == kNone) return;
  const bool remains = pool.alive(edge.slot) && pool.generation(edge.slot) == entry.generation &&
                       pool.level(edge.slot) == 0 &&
                       !aside_.contains({edge.pool, edge.slot, entry.generation});
  may_be_cut_ = true;  // it was removed or changed
  if (!remains) remove_term({edge.pool, edge.slot});
}

bool LiveProblem::can_move(std::uint32_t pool, std::uint32_t slot) const {
  return !graph_.vertex_pools()[pool]->fixed(slot) && !vertices_[pool][slot].is_held;
}

void LiveProblem::apply_vertex(VertexRef vertex) {
  const detail::VertexPool& pool = *graph_.vertex_pools()[vertex.pool];
  VertexEntry& entry = vertices_[vertex.pool][vertex.slot];
  const bool is_same =
      entry.is_known && pool.alive(vertex.slot) && pool.generation(vertex.slot) == entry.generation;
  if (!is_same) entry.is_held = false;  // another vertex uses the slot
  const bool moves = pool.alive(vertex.slot) && can_move(vertex.pool, vertex.slot);
  if (moves && !pool.bounds(vertex.slot).empty()) {
    throw InvalidArgument("Smoother: vertex " + std::to_string(pool.id(vertex.slot)) +
                          " has bounds; use optimize()");
  }
  const bool has_place =
      entry.block != kNone && is_same && moves &&
      factor_.dim(entry.block) == static_cast<std::uint32_t>(pool.tangent_dim(vertex.slot));
  if (entry.block != kNone && !has_place) {
    while (!factor_.terms_of(entry.block).empty()) {
      const EdgeName name = edge_of_[factor_.terms_of(entry.block).front()];
      again_.push_back({name.pool, name.slot, edges_[name.pool][name.slot].generation});
      remove_term(name);
    }
    remove_block(entry);
    may_be_cut_ = true;
  } else if (has_place) {
    set_point(vertex.pool, vertex.slot, entry.block);
  } else if (is_same && (!moves || !entry.moved)) {
    may_be_cut_ = true;
    for (const EdgeRef& edge : graph_.edges(vertex)) {
      again_.push_back(edge);
      const EdgeEntry& known = edges_[edge.pool][edge.slot];
      if (moves && known.term != kNone && known.generation == edge.generation)
        remove_term({edge.pool, edge.slot});  // because the term lacks this vertex
    }
  }
  entry.is_known = pool.alive(vertex.slot);
  entry.generation = pool.alive(vertex.slot) ? pool.generation(vertex.slot) : 0;
  entry.moved = moves;
}

void LiveProblem::apply_verdict(EdgeRef edge) {
  if (aside_.contains(edge) && edges_[edge.pool][edge.slot].term != kNone)
    return remove_term({edge.pool, edge.slot});
  apply_edge(edge);
}

/// Makes a term for the edge if it takes part, or queues the edge if it has a term.
void LiveProblem::apply_edge(EdgeRef edge) {
  const detail::EdgePool& pool = *graph_.edge_pools()[edge.pool];
  EdgeEntry& entry = edges_[edge.pool][edge.slot];
  if (entry.term != kNone) return queue({edge.pool, edge.slot});
  if (!pool.alive(edge.slot) || pool.level(edge.slot) != 0) return;
  if (!aside_.empty() && aside_.contains({edge.pool, edge.slot, pool.generation(edge.slot)})) return;
  if (const_cast<detail::EdgePool&>(pool).shift(edge.slot) != nullptr)
    throw InvalidArgument("Smoother: expected edges without constraints; use optimize()");
  blocks_.clear();
  const auto slots = pool.vertex_slots(edge.slot);
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const std::uint32_t vertex_pool = pool.vertex_pool(edge.slot, static_cast<int>(i));
    if (can_move(vertex_pool, slots[i])) blocks_.push_back(require_block(vertex_pool, slots[i]));
  }
  note_anchor(edge.pool, edge.slot);
  if (blocks_.empty()) return;
  entry.generation = pool.generation(edge.slot);
  entry.term = factor_.add_term(blocks_);
  if (entry.term >= edge_of_.size()) edge_of_.resize(entry.term + std::size_t{1});
  edge_of_[entry.term] = {edge.pool, edge.slot};
  ++term_count_;
  queue({edge.pool, edge.slot});
}

void LiveProblem::remove_term(EdgeName name) {
  EdgeEntry& entry = edges_[name.pool][name.slot];
  const auto blocks = factor_.blocks_of(entry.term);
  maybe_unused_.insert(maybe_unused_.end(), blocks.begin(), blocks.end());
  factor_.remove_term(entry.term);
  entry.term = kNone;
  --term_count_;
}

Index LiveProblem::require_block(std::uint32_t p, std::uint32_t slot) {
  VertexEntry& entry = vertices_[p][slot];
  if (entry.block != kNone) return entry.block;
  const detail::VertexPool& pool = *graph_.vertex_pools()[p];
  if (!pool.bounds(slot).empty())
    throw InvalidArgument("Smoother: vertex " + std::to_string(pool.id(slot)) +
                          " has bounds; use optimize()");
  const std::vector<std::uint8_t>& kinds = kinds_of(p, slot);
  noticeable_.clear();
  for (int i = 0; i < pool.tangent_dim(slot); ++i)
    noticeable_.push_back(distance_of(options_.noticeable, kinds[static_cast<std::size_t>(i)]));
  entry.block = factor_.add_block(noticeable_);
  entry.is_known = entry.moved = true;
  entry.generation = pool.generation(slot);
  if (entry.block >= vertex_of_.size()) vertex_of_.resize(entry.block + std::size_t{1});
  vertex_of_[entry.block] = {p, slot, entry.generation};
  ++block_count_;
  entry.is_pinned = false;
  new_vertices_.push_back(vertex_of_[entry.block]);
  set_point(p, slot, entry.block);
  return entry.block;
}

void LiveProblem::remove_block(VertexEntry& entry) {
  factor_.remove_block(entry.block);
  entry.block = kNone;
  --block_count_;
}

/// Whether the blocks of a new edge are in different parts of the graph. A new block is in the part of the
/// blocks to which an edge has joined it.
bool LiveProblem::joins_parts() {
  part_of_.resize(vertex_of_.size());
  const auto part_of = [&](Index block) {
    const Index root = factor_.root_of(block);
    return root != kNone ? root : part_of_[block].first == applies_ ? part_of_[block].second : kNone;
  };
  Index part = kNone;
  bool joins = false;
  for (const Index block : blocks_) {
    const Index own = part_of(block);
    joins = joins || (part != kNone && own != kNone && own != part);
    if (own != kNone) part = own;
  }
  constexpr Index kNewParts = 0x80000000u;  // numbers that no front has
  if (part == kNone && !blocks_.empty()) part = kNewParts + blocks_[0];
  for (const Index block : blocks_) {
    if (part_of(block) == kNone) part_of_[block] = {applies_, part};
  }
  return joins;
}

/// Notes whether a new edge may anchor a component, or join two of them.
void LiveProblem::note_anchor(std::uint32_t p, std::uint32_t edge) {
  if (held_.empty() && held_directions_.empty()) return;
  const detail::EdgePool& pool = *graph_.edge_pools()[p];
  const auto slots = pool.vertex_slots(edge);
  bool reaches_fixed = false, reaches_held = false;
  int vertex_count = 0;  // without parameters
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const std::uint32_t v = pool.vertex_pool(edge, static_cast<int>(i));
    const detail::VertexPool& vertices = *graph_.vertex_pools()[v];
    vertex_count += vertices.parameter(slots[i]) && vertices.fixed(slots[i]) ? 0 : 1;
    reaches_fixed = reaches_fixed || (vertices.fixed(slots[i]) && !vertices.parameter(slots[i]));
    reaches_held = reaches_held || vertices_[v][slots[i]].is_held;
  }
  const bool is_relative = vertex_count > 1 && (pool.is_rigid() || is_relative_[p]);
  if (joins_parts() || reaches_fixed || reaches_held || !is_relative) may_be_anchored_ = true;
}

/// Says for each entry of the tangent whether it is a length, an angle or something else.
const std::vector<std::uint8_t>& LiveProblem::kinds_of(std::uint32_t p, std::uint32_t slot) {
  const detail::VertexPool& pool = *graph_.vertex_pools()[p];
  const auto dim = static_cast<std::size_t>(pool.tangent_dim(slot));
  std::vector<std::uint8_t>& kinds = kinds_[p];
  if (kinds.size() >= dim) return kinds;
  kinds.assign(dim, kOther);
  detail::Frame before, after;
  if (!pool.get_frame(slot, before)) return kinds;
  constexpr double kStep = 1e-3, kBound = 1e-6;
  const std::unique_ptr<detail::VertexPool> moved = pool.make_store();
  const std::uint32_t offset = 0;
  std::vector<double> step(dim, 0);
  for (std::size_t i = 0; i < dim; ++i) {
    step[i] = kStep;
    moved->copy_estimates({&slot, 1}, pool);
    moved->set_to_sum({&slot, 1}, pool, {&offset, 1}, step.data());
    step[i] = 0;
    moved->get_frame(slot, after);
    const auto [turned, shifted] = differ(before, after, kBound);
    if (turned || shifted) kinds[i] = turned ? kAngle : kLength;
  }
  return kinds;
}

Index LiveProblem::block(VertexRef vertex) const {
  if (!graph_.contains(vertex)) throw InvalidArgument("Smoother: stale vertex handle");
  const bool is_known = vertex.pool < vertices_.size() && vertex.slot < vertices_[vertex.pool].size();
  if (!is_known) return kNone;
  const VertexEntry& entry = vertices_[vertex.pool][vertex.slot];
  return entry.generation == vertex.generation ? entry.block : kNone;
}

bool LiveProblem::takes_part(VertexRef vertex) const {
  if (block(vertex) != kNone || graph_.is_fixed(vertex)) return true;
  return std::any_of(held_.begin(), held_.end(), [&](const auto& held) { return held.vertex == vertex; });
}

// ---- Linearization ----

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

// ---- Estimates ----

void LiveProblem::move(std::span<const Index> blocks) {
  for (SlotList& list : lists_) {
    list.slots.clear();
    list.offsets.clear();
  }
  moved_in_.resize(vertex_of_.size());
  for (const Index block : blocks) {
    const auto [pool, slot, generation] = vertex_of_[block];
    lists_[pool].slots.push_back(slot);
    lists_[pool].offsets.push_back(factor_.x_offset(block));
    if (moved_in_[block] == transaction_) continue;
    moved_in_[block] = transaction_;
    moved_.push_back(block);
    before_[pool]->copy_estimates({&slot, 1}, *graph_.vertex_pools()[pool]);
  }
  for (std::size_t p = 0; p < lists_.size(); ++p) {
    if (lists_[p].slots.empty()) continue;
    graph_.vertex_pools()[p]->set_to_sum(lists_[p].slots, *points_[p], lists_[p].offsets, factor_.all_x());
  }
}

void LiveProblem::restore() {
  for (const Index block : moved_) {
    const auto [pool, slot, generation] = vertex_of_[block];
    graph_.vertex_pools()[pool]->copy_estimates({&slot, 1}, *before_[pool]);
  }
  moved_.clear();
}

double LiveProblem::relinearize(std::span<const Index> blocks, double scale, double max_flops,
                                bool takes_one) {
  std::vector<std::pair<double, Index>>& far = far_;
  far.clear();
  const auto look_at = [&](Index block) {
    const auto [pool, slot, generation] = vertex_of_[block];
    const VertexEntry& entry = vertices_[pool][slot];
    if (entry.block != block || entry.is_pinned) return;
    const auto x = factor_.x(block);
    const std::vector<std::uint8_t>& kinds = kinds_[pool];
    double distance = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
      distance = std::max(distance, std::abs(x[i]) / distance_of(options_.relinearize, kinds[i]));
    if (!(distance <= scale)) far.emplace_back(distance, block);
  };
  for (const Index block : blocks) look_at(block);
  if (!waiting_.empty()) {
    for (const Index block : waiting_) look_at(block);
    std::sort(far.begin(), far.end());
    far.erase(std::unique(far.begin(), far.end()), far.end());
    waiting_.clear();
  }
  double farthest = 0;
  for (const auto& [distance, block] : far) farthest = std::max(farthest, distance);
  const bool is_limited = max_flops < std::numeric_limits<double>::infinity();
  if (is_limited) std::sort(far.begin(), far.end(), std::greater<>());
  factor_.begin_prediction();
  for (const auto& [distance, block] : far) {
    const bool must = takes_one && block == far.front().second;
    const double limit = must ? std::numeric_limits<double>::infinity() : max_flops;
    const double flops = is_limited ? factor_.expect_change(block, limit) : 0;
    if (flops > limit) {
      waiting_.push_back(block);
      continue;
    }
    max_flops -= flops;
    const auto [pool, slot, generation] = vertex_of_[block];
    set_point(pool, slot, block);
  }
  return farthest;
}

// ---- Marginalization ----

std::vector<VertexRef> LiveProblem::followers(std::span<const VertexRef> leaving,
                                              detail::FunctionRef<bool(VertexRef)> stays) const {
  std::vector<VertexRef> result;
  const auto leaves = [&](Index b) {
    return std::find(leaving.begin(), leaving.end(), vertex_of_[b]) != leaving.end();
  };
  const auto for_each_neighbor = [&](Index b, auto&& f) {
    for (const Index term : factor_.terms_of(b)) {
      if (dynamic_cast<const MarginalPool*>(graph_.edge_pools()[edge_of_[term].pool].get()) != nullptr)
        continue;
      for (const Index other : factor_.blocks_of(term)) {
        if (other != b) f(other);
      }
    }
  };
  // The neighbors of a vertex, which may be held and then has no block.
  const auto for_each_neighbor_of = [&](VertexRef vertex, auto&& f) {
    if (block(vertex) != kNone) return for_each_neighbor(block(vertex), f);
    for (const EdgeRef& edge : graph_.edges(vertex)) {
      for (const VertexRef& other : graph_.vertices(edge)) {
        if (other != vertex && block(other) != kNone) f(block(other));
      }
    }
  };
  const auto look_at = [&](Index b) {
    if (leaves(b) || stays(vertex_of_[b])) return;
    bool is_needed = false;
    for_each_neighbor(b, [&](Index other) { is_needed = is_needed || !leaves(other); });
    if (!is_needed) result.push_back(vertex_of_[b]);
  };
  for (const VertexRef& vertex : leaving) {
    for_each_neighbor_of(vertex, look_at);
    if (block(vertex) == kNone) continue;
    for (const Index term : factor_.terms_of(block(vertex))) {
      for (const Index other : factor_.blocks_of(term)) look_at(other);  // also those that only a prior joins
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

void LiveProblem::marginalize(std::span<const VertexRef> vertices) {
  std::vector<Index> terms;
  std::vector<VertexRef> others;
  for (const VertexRef& vertex : vertices) {
    for (const EdgeRef& edge : graph_.edges(vertex)) {
      const EdgeEntry& entry = edges_[edge.pool][edge.slot];
      if (entry.term != kNone && entry.generation == edge.generation) terms.push_back(entry.term);
    }
  }
  std::sort(terms.begin(), terms.end());
  terms.erase(std::unique(terms.begin(), terms.end()), terms.end());
  for (const Index term : terms) {
    for (const Index b : factor_.blocks_of(term)) {
      if (std::find(vertices.begin(), vertices.end(), vertex_of_[b]) == vertices.end())
        others.push_back(vertex_of_[b]);
    }
  }
  std::vector<VertexRef> gone;  // without those that are held
  std::copy_if(vertices.begin(), vertices.end(), std::back_inserter(gone),
               [&](VertexRef vertex) { return block(vertex) != kNone; });
  DenseModel model;
  model.set_vertices(graph_, gone, std::move(others));
  const double* const values = factor_.values();
  for (const Index term : terms) {
    const auto blocks = factor_.blocks_of(term);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      const Eigen::Index rows = factor_.dim(blocks[i]), row = model.first_of(vertex_of_[blocks[i]]);
      model.b.segment(row, rows) +=
          Eigen::Map<const Eigen::VectorXd>(values + factor_.gradient_of(term, i), rows);
      for (std::size_t j = 0; j <= i; ++j) {
        const Eigen::Index columns = factor_.dim(blocks[j]), column = model.first_of(vertex_of_[blocks[j]]);
        const Eigen::Map<const Eigen::MatrixXd> part(values + factor_.block_of(term, i, j), rows, columns);
        model.H.block(row, column, rows, columns) += part;
        if (i != j) model.H.block(column, row, columns, rows) += part.transpose();
      }
    }
  }
  const DenseModel prior = eliminated(model, gone.size());
  if (!prior.vertices.empty()) add_marginal_prior(graph_, prior, points_);
  for (const VertexRef& vertex : prior.vertices) vertices_[vertex.pool][vertex.slot].is_pinned = true;
  for (const VertexRef& vertex : vertices) graph_.remove(vertex);
}

}  // namespace boxplus
