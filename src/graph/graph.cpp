// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/graph/graph.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "graph/incidence.h"
#include "graph/weighted_rows.h"

namespace boxplus {

Id Graph::claim_id(const detail::IdMap& ids, Id& next, std::optional<Id> id, const char* what) {
  if (!id) {
    while (ids.contains(next)) ++next;
    return next++;
  }
  if (*id < 0)
    throw InvalidArgument(std::string(what) + " id: expected a number ≥ 0, got " + std::to_string(*id));
  if (ids.contains(*id))
    throw InvalidArgument(std::string(what) + " id " + std::to_string(*id) + " is taken");
  return *id;
}

VertexRef Graph::lookup(const detail::IdMap& ids, Id id, const char* what) const {
  const VertexRef* found = ids.find(id);
  if (!found) throw InvalidArgument("there is no " + std::string(what) + " " + std::to_string(id));
  return *found;
}

void Graph::throw_wrong_type(VertexRef vertex, std::string_view expected) const {
  throw InvalidArgument("vertex " + std::to_string(id(vertex)) + ": expected the type " +
                        std::string(expected) + ", but it is a " +
                        std::string(pools_.vertices[vertex.pool]->type_name()));
}

void Graph::throw_wrong_type(EdgeRef edge, std::string_view expected) const {
  throw InvalidArgument("edge handle: expected an edge of the type " + std::string(expected) +
                        ", but it is a " + std::string(pools_.edges[edge.pool]->type_name()));
}

bool Graph::contains(VertexRef vertex) const {
  return vertex.pool < pools_.vertices.size() && vertex.slot < pools_.vertices[vertex.pool]->slots() &&
         pools_.vertices[vertex.pool]->alive(vertex.slot) &&
         pools_.vertices[vertex.pool]->generation(vertex.slot) == vertex.generation;
}

bool Graph::contains(EdgeRef edge) const {
  return edge.pool < pools_.edges.size() && edge.slot < pools_.edges[edge.pool]->slots() &&
         pools_.edges[edge.pool]->alive(edge.slot) &&
         pools_.edges[edge.pool]->generation(edge.slot) == edge.generation;
}

void Graph::check(VertexRef vertex) const {
  if (!contains(vertex))
    throw InvalidArgument("stale vertex handle: its vertex was removed or belongs to another graph");
}

void Graph::check(EdgeRef edge) const {
  if (!contains(edge))
    throw InvalidArgument("stale edge handle: its edge was removed or belongs to another graph");
}

/// Finds a vertex that appears twice.
std::optional<VertexRef> Graph::find_repetition(std::span<const VertexRef> vertices) {
  constexpr std::size_t kFew = 8;
  if (vertices.size() <= kFew) {
    for (std::size_t k = 1; k < vertices.size(); ++k) {
      const auto before = vertices.first(k);
      if (std::find(before.begin(), before.end(), vertices[k]) != before.end()) return vertices[k];
    }
    return std::nullopt;
  }
  std::vector<VertexRef> sorted(vertices.begin(), vertices.end());
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  return twice == sorted.end() ? std::nullopt : std::optional(*twice);
}

void Graph::reserve_edges(EdgeRef like, std::size_t count) {
  check(like);
  constexpr std::size_t kMost = std::numeric_limits<std::uint32_t>::max();
  if (count > kMost) {
    throw InvalidArgument("reserve_edges(): expected at most " + std::to_string(kMost) + " edges, got " +
                          std::to_string(count));
  }
  pools_.edges[like.pool]->reserve(count);
}

void Graph::check_distinct(std::span<const VertexRef> vertices) const {
  if (vertices.empty()) throw InvalidArgument("an edge needs at least one vertex");
  if (const auto twice = find_repetition(vertices)) {
    throw InvalidArgument("vertex " + std::to_string(id(*twice)) + " appears twice in one edge");
  }
}

void Graph::throw_misfit(const InvalidArgument& misfit, std::span<const VertexRef> vertices) const {
  constexpr std::size_t kMostNames = 4;
  std::string names;
  for (const VertexRef& vertex : vertices.first(std::min(vertices.size(), kMostNames))) {
    names += names.empty() ? "" : ", ";
    names += pools_.vertices[vertex.pool]->parameter(vertex.slot) ? "parameter " : "vertex ";
    names += std::to_string(id(vertex)) + " (size " + std::to_string(tangent_dim(vertex)) + ")";
  }
  if (vertices.size() > kMostNames) names += ", …";
  throw InvalidArgument("edge of " + names + ": " + misfit.what());
}

void Graph::check_sizes_of_edges(VertexRef vertex) const {
  for (const EdgeRef& edge : edges(vertex)) {
    try {
      (void)error(edge);
    } catch (const InvalidArgument& misfit) {
      throw_misfit(misfit, vertices(edge));
    }
  }
}

void Graph::mark_parameter(VertexRef vertex) {
  pools_.vertices[vertex.pool]->set_flag(vertex.slot, detail::VertexPool::kParameter, true);
  pools_.vertices[vertex.pool]->set_flag(vertex.slot, detail::VertexPool::kFixed, true);
}

std::optional<VertexRef> Graph::find_vertex(Id id) const {
  const VertexRef* found = vertex_ids_.find(id);
  return found ? std::optional(*found) : std::nullopt;
}

std::optional<VertexRef> Graph::find_parameter(Id id) const {
  const VertexRef* found = parameter_ids_.find(id);
  return found ? std::optional(*found) : std::nullopt;
}

Id Graph::id(VertexRef vertex) const {
  check(vertex);
  return pools_.vertices[vertex.pool]->id(vertex.slot);
}

void Graph::change_id(VertexRef vertex, Id new_id) {
  check(vertex);
  detail::VertexPool& pool = *pools_.vertices[vertex.pool];
  if (pool.id(vertex.slot) == new_id) return;
  detail::IdMap& ids = pool.parameter(vertex.slot) ? parameter_ids_ : vertex_ids_;
  Id unused = 0;
  claim_id(ids, unused, new_id, pool.parameter(vertex.slot) ? "parameter" : "vertex");
  ids.make_room();
  ids.erase(pool.id(vertex.slot));
  ids.insert(new_id, vertex);
  pool.ids_[vertex.slot] = new_id;
  note_new_structure();
}

int Graph::tangent_dim(VertexRef vertex) const {
  check(vertex);
  return pools_.vertices[vertex.pool]->tangent_dim(vertex.slot);
}

void Graph::set_fixed(VertexRef vertex, bool fixed) {
  if (is_fixed(vertex) == fixed) return;
  pools_.vertices[vertex.pool]->set_flag(vertex.slot, detail::VertexPool::kFixed, fixed);
  note_new_structure();
  note_change(vertex);
}

bool Graph::is_fixed(VertexRef vertex) const {
  check(vertex);
  return pools_.vertices[vertex.pool]->fixed(vertex.slot);
}

void Graph::fix_directions(VertexRef vertex, std::span<const int> directions) {
  const int dim = tangent_dim(vertex);
  std::vector<int> sorted(directions.begin(), directions.end());
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  for (const int direction : sorted) {
    if (direction >= 0 && direction < dim) continue;
    throw InvalidArgument("fix_directions(): expected a direction of the tangent of vertex " +
                          std::to_string(id(vertex)) + ", from 0 to " + std::to_string(dim - 1) + ", got " +
                          std::to_string(direction));
  }
  if (std::ranges::equal(sorted, fixed_directions(vertex))) return;
  pools_.vertices[vertex.pool]->fixed_directions_.set(vertex.slot, std::move(sorted));
  note_new_structure();
  note_change(vertex);
}

std::span<const int> Graph::fixed_directions(VertexRef vertex) const {
  check(vertex);
  return pools_.vertices[vertex.pool]->fixed_directions(vertex.slot);
}

void Graph::set_bounds(VertexRef vertex, int entry, double lower, double upper) {
  const int dim = tangent_dim(vertex);
  detail::VertexPool& pool = *pools_.vertices[vertex.pool];
  const auto complain = [&](const std::string& expected) {
    throw InvalidArgument("set_bounds(): " + expected + " (vertex " + std::to_string(id(vertex)) + ")");
  };
  if (entry < 0 || entry >= dim)
    complain("expected an entry from 0 to " + std::to_string(dim - 1) + ", got " + std::to_string(entry));
  if (pool.entry(vertex.slot, entry) == nullptr)
    complain("expected an entry to which steps are added, but entry " + std::to_string(entry) + " of " +
             std::string(pool.type_name()) + " is not a plain number");
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (!(lower <= upper) || lower == kInfinity || upper == -kInfinity)
    complain("expected lower ≤ upper, with a finite number between them, got " + std::to_string(lower) +
             " and " + std::to_string(upper));
  const std::span<const detail::Bound> old = pool.bounds(vertex.slot);
  const bool had_bounds = !old.empty();
  std::vector<detail::Bound> bounds;
  for (const detail::Bound& bound : old) {
    if (bound.entry != entry) bounds.push_back(bound);
  }
  if (lower != -kInfinity || upper != kInfinity) {
    const auto after = [&](const detail::Bound& bound) { return bound.entry > entry; };
    bounds.insert(std::find_if(bounds.begin(), bounds.end(), after), {entry, lower, upper});
  }
  const bool has_bounds = !bounds.empty();
  pool.bounds_.set(vertex.slot, std::move(bounds));
  note_change(vertex);
  if (had_bounds != has_bounds) note_new_structure();  // the treatment of the gauge depends on it
}

std::span<const detail::Bound> Graph::bounds(VertexRef vertex) const {
  check(vertex);
  return pools_.vertices[vertex.pool]->bounds(vertex.slot);
}

void Graph::set_eliminated(VertexRef vertex, bool eliminated) {
  if (is_eliminated(vertex) == eliminated) return;
  pools_.vertices[vertex.pool]->set_flag(vertex.slot, detail::VertexPool::kEliminated, eliminated);
  note_new_structure();
}

bool Graph::is_eliminated(VertexRef vertex) const {
  check(vertex);
  return pools_.vertices[vertex.pool]->eliminated(vertex.slot);
}

std::vector<VertexRef> Graph::vertices(EdgeRef edge) const {
  check(edge);
  const detail::EdgePool& pool = *pools_.edges[edge.pool];
  std::vector<VertexRef> result;
  for (std::uint32_t slot : pool.vertex_slots(edge.slot)) {
    const std::uint32_t index = pool.vertex_pool(edge.slot, static_cast<int>(result.size()));
    result.push_back({index, slot, pools_.vertices[index]->generation(slot)});
  }
  return result;
}

detail::InformationView Graph::information(EdgeRef edge) const {
  check(edge);
  return pools_.edges[edge.pool]->information(edge.slot);
}

void Graph::set_information(EdgeRef edge, const Information& information) {
  check(edge);
  detail::EdgePool& pool = *pools_.edges[edge.pool];
  const int rows = pool.shape(edge.slot).rows;
  const auto structure = [&] {
    std::vector<bool> row_is_structural;
    const detail::InformationView omega = pool.information(edge.slot, rows);
    if (structural_rows(omega) == rows) return row_is_structural;
    for (int i = 0; i < rows; ++i) row_is_structural.push_back(is_structural(omega, i));
    return row_is_structural;
  };
  const std::vector<bool> before = structure();
  pool.information_.set(edge.slot, information, rows);
  note_change(edge);
  if (structure() != before) note_new_structure();  // the gauge freedom depends on it
}

void Graph::set_kernel(EdgeRef edge, std::shared_ptr<const RobustKernel> kernel) {
  check(edge);
  pools_.edges[edge.pool]->set_kernel(edge.slot, std::move(kernel));
  note_change(edge);
}

const RobustKernel* Graph::kernel(EdgeRef edge) const {
  check(edge);
  return pools_.edges[edge.pool]->kernel(edge.slot);
}

void Graph::set_enabled(EdgeRef edge, bool enabled) {
  check(edge);
  auto& flags = pools_.edges[edge.pool]->flags_[edge.slot];
  flags = static_cast<std::uint8_t>(enabled ? flags | detail::EdgePool::kEnabled
                                            : flags & ~detail::EdgePool::kEnabled);
  note_change(edge);
}

bool Graph::is_enabled(EdgeRef edge) const {
  check(edge);
  return pools_.edges[edge.pool]->enabled(edge.slot);
}

void Graph::set_level(EdgeRef edge, int level) {
  check(edge);
  detail::EdgePool& pool = *pools_.edges[edge.pool];
  if (pool.level(edge.slot) == level) return;
  if (pool.levels_.empty()) pool.levels_.resize(pool.slots(), 0);
  pool.levels_[edge.slot] = level;
  note_new_structure();
  note_change(edge);
}

int Graph::level(EdgeRef edge) const {
  check(edge);
  return pools_.edges[edge.pool]->level(edge.slot);
}

void Graph::remove(EdgeRef edge) {
  check(edge);
  pools_.edges[edge.pool]->remove(edge.slot);
  note_new_structure();
  note_change(edge);
}

double Graph::chi2() const {
  double sum = 0;
  for (const auto& pool : pools_.edges) {
    for (std::uint32_t edge = 0; edge < pool->slots(); ++edge) {
      if (!pool->alive(edge) || !pool->enabled(edge)) continue;
      double e2 = 0;
      pool->chi2(std::span(&edge, 1), &e2);
      const RobustKernel* kernel = pool->kernel(edge);
      sum += kernel && std::isfinite(e2) ? (*kernel)(e2).value : e2;  // a kernel must not hide NaN or Inf
    }
  }
  return sum;
}

void Graph::push() {
  detail::SavedState saved;
  for (const auto& pool : pools_.vertices) {
    detail::SavedState::Part& part = saved.parts.emplace_back();
    for (std::uint32_t slot = 0; slot < pool->slots(); ++slot) {
      if (!pool->alive(slot)) continue;
      part.slots.push_back(slot);
      part.generations.push_back(pool->generation(slot));
    }
  }
  save(std::move(saved));
}

void Graph::push(std::span<const VertexRef> vertices) {
  detail::SavedState saved;
  saved.parts.resize(pools_.vertices.size());
  for (const VertexRef& vertex : vertices) {
    check(vertex);
    saved.parts[vertex.pool].slots.push_back(vertex.slot);
    saved.parts[vertex.pool].generations.push_back(vertex.generation);
  }
  save(std::move(saved));
}

void Graph::save(detail::SavedState saved) {
  for (std::size_t p = 0; p < saved.parts.size(); ++p)
    pools_.vertices[p]->save(saved.parts[p].slots, saved.parts[p].estimates);
  stack_.push_back(std::move(saved));
}

void Graph::pop() {
  if (stack_.empty()) throw InvalidArgument("pop: expected an earlier push, but the stack is empty");
  detail::SavedState saved = std::move(stack_.back());
  stack_.pop_back();
  bool resized = false;
  for (std::size_t p = 0; p < saved.parts.size(); ++p) {
    detail::VertexPool& pool = *pools_.vertices[p];
    detail::SavedState::Part& part = saved.parts[p];
    std::vector<int> dims(part.slots.size());
    for (std::size_t k = 0; k < part.slots.size(); ++k) {
      const bool exists =
          contains(VertexRef{static_cast<std::uint32_t>(p), part.slots[k], part.generations[k]});
      if (!exists) part.slots[k] = detail::VertexPool::kNoSlot;
      if (exists) dims[k] = pool.tangent_dim(part.slots[k]);
    }
    pool.restore(part.slots, *part.estimates);
    for (std::size_t k = 0; k < part.slots.size(); ++k)
      resized |= part.slots[k] != detail::VertexPool::kNoSlot && pool.tangent_dim(part.slots[k]) != dims[k];
  }
  if (resized) note_new_structure();
  note_moved();
}

void Graph::discard_top() {
  if (stack_.empty()) throw InvalidArgument("discard_top: expected an earlier push, but the stack is empty");
  stack_.pop_back();
}

std::size_t Graph::vertex_count() const {
  return vertex_ids_.size();
}

std::size_t Graph::edge_count() const {
  std::size_t count = 0;
  for (const auto& pool : pools_.edges) count += pool->alive_count();
  return count;
}

std::vector<VertexRef> Graph::all_vertices() const {
  return vertex_ids_.by_id();
}

std::vector<VertexRef> Graph::all_parameters() const {
  return parameter_ids_.by_id();
}

std::vector<EdgeRef> Graph::all_edges() const {
  std::vector<EdgeRef> result;
  result.reserve(edge_count());
  for (std::uint32_t p = 0; p < pools_.edges.size(); ++p) {
    for (std::uint32_t edge = 0; edge < pools_.edges[p]->slots(); ++edge) {
      if (pools_.edges[p]->alive(edge)) result.push_back({p, edge, pools_.edges[p]->generation(edge)});
    }
  }
  return result;
}

void Graph::clear() {
  const std::uint64_t revision = revision_ + 1;
  detail::ChangeLog* const log = log_;
  Graph empty;
  take_elements(empty);
  revision_ = revision;
  log_ = log;
  note_moved();
}

}  // namespace boxplus
