// SPDX-License-Identifier: BSD-3-Clause
#include "incremental/live_problem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "boxplus/base/error.h"

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

detail::ChangeLog everything_in(const Graph& graph) {
  detail::ChangeLog all;
  for (std::uint32_t p = 0; p < graph.vertex_pools().size(); ++p) {
    const detail::VertexPool& pool = *graph.vertex_pools()[p];
    for (std::uint32_t slot = 0; slot < pool.slots(); ++slot) {
      if (pool.alive(slot)) all.vertices.push_back({p, slot, pool.generation(slot)});
    }
  }
  all.edges = graph.all_edges();
  return all;
}

LiveProblem::LiveProblem(Graph& graph, const SmootherOptions& options, const std::set<EdgeRef>& aside)
    : graph_(graph), options_(options), aside_(aside), linearizer_(graph) {
  apply(everything_in(graph));
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
  if (!left_out_.empty()) take_in(log);
  for (const VertexRef& vertex : log.vertices) apply_vertex(vertex);
  for (const EdgeRef& edge : log.edges) apply_edge(edge);
  for (const EdgeRef& edge : again_) apply_edge(edge);
  remove_unused_blocks();
  std::erase_if(few_rows_, [&](Index block) { return !has_few_rows(block); });
}

void LiveProblem::remove_unused_blocks() {
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
  const bool is_same = pool.alive(edge.slot) && pool.generation(edge.slot) == entry.generation;
  may_be_cut_ = true;  // it was removed or changed
  if (!is_same || !may_take_part({edge.pool, edge.slot})) remove_term({edge.pool, edge.slot});
}

/// Whether the edge is there, is of level 0, is enabled and is not set aside.
bool LiveProblem::may_take_part(EdgeName name) const {
  const detail::EdgePool& pool = *graph_.edge_pools()[name.pool];
  if (!pool.alive(name.slot) || pool.level(name.slot) != 0 || !pool.enabled(name.slot)) return false;
  return aside_.empty() || !aside_.contains({name.pool, name.slot, pool.generation(name.slot)});
}

std::vector<EdgeRef> LiveProblem::edges() const {
  std::vector<EdgeRef> result;
  for (const EdgeRef& edge : graph_.all_edges()) {
    const EdgeName name{edge.pool, edge.slot};
    if (may_take_part(name) && !is_left_out(name)) result.push_back(edge);
  }
  return result;
}

bool LiveProblem::can_move(std::uint32_t pool, std::uint32_t slot) const {
  return !graph_.vertex_pools()[pool]->fixed(slot) && !vertices_[pool][slot].is_held;
}

void LiveProblem::apply_vertex(VertexRef vertex) {
  const detail::VertexPool& pool = *graph_.vertex_pools()[vertex.pool];
  VertexEntry& entry = vertices_[vertex.pool][vertex.slot];
  const bool is_same =
      entry.is_known && pool.alive(vertex.slot) && pool.generation(vertex.slot) == entry.generation;
  if (!is_same) entry.is_held = entry.is_left_out = false;  // another vertex uses the slot
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
  if (!may_take_part({edge.pool, edge.slot}) || is_left_out({edge.pool, edge.slot})) return;
  if (graph_.edge_pools()[edge.pool]->shift(edge.slot) != nullptr)
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
  few_rows_.insert(few_rows_.end(), blocks.begin(), blocks.end());
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
    noticeable_.push_back(distance_of(options_.noticeable, kinds[i]));
  entry.block = factor_.add_block(noticeable_);
  entry.is_known = entry.moved = true;
  entry.generation = pool.generation(slot);
  if (entry.block >= vertex_of_.size()) vertex_of_.resize(entry.block + std::size_t{1});
  vertex_of_[entry.block] = {p, slot, entry.generation};
  ++block_count_;
  few_rows_.push_back(entry.block);
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

}  // namespace boxplus
