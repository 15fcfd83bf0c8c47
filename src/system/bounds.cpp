// SPDX-License-Identifier: BSD-3-Clause
#include "system/bounds.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace boxplus {
namespace {

/// Whether the entry is at the limit towards which `direction` points.
bool is_at_limit(const detail::Bound& bound, double value, double direction) {
  return direction < 0 ? value <= bound.lower : direction > 0 && value >= bound.upper;
}

/// A step that is at most this fraction of what the model asks for has ended almost at once.
constexpr double kAlmostAtOnce = 1e-2;

void move_within(const detail::VertexPool& pool, std::uint32_t slot, double& value,
                 const detail::Bound& bound) {
  const std::span<const int> fixed = pool.fixed_directions(slot);
  if (std::isnan(value) || std::ranges::find(fixed, bound.entry) != fixed.end()) return;
  value = std::clamp(value, bound.lower, bound.upper);
}

}  // namespace

void move_within_bounds(const Graph& graph, std::span<const VertexRef> vertices) {
  const auto move = [](detail::VertexPool& pool, std::uint32_t slot) {
    if (pool.fixed(slot)) return;
    for (const detail::Bound& bound : pool.bounds(slot))
      move_within(pool, slot, *pool.entry(slot, bound.entry), bound);
  };
  for (const VertexRef& vertex : vertices) move(*graph.vertex_pools()[vertex.pool], vertex.slot);
  if (!vertices.empty()) return;
  for (const auto& pool : graph.vertex_pools()) {
    if (!pool->has_bounds()) continue;
    for (std::uint32_t slot = 0; slot < pool->slots(); ++slot) {
      if (pool->alive(slot)) move(*pool, slot);
    }
  }
}

void Bounds::read(const Graph& graph, const Plan& plan) {
  items_.clear();
  held_ = 0;
  for (const VertexList& list : plan.vertices) {
    detail::VertexPool& pool = *graph.vertex_pools()[list.pool];
    if (!pool.has_bounds()) continue;
    for (std::size_t k = 0; k < list.slots.size(); ++k) {
      const std::span<const int> fixed = pool.fixed_directions(list.slots[k]);
      for (const detail::Bound& bound : pool.bounds(list.slots[k])) {
        if (std::ranges::find(fixed, bound.entry) != fixed.end()) continue;
        const std::uint32_t scalar = list.offsets[k] + static_cast<std::uint32_t>(bound.entry);
        items_.push_back({list.pool, list.slots[k], scalar, bound});
      }
    }
  }
  scratch_.resize(empty() ? 0 : plan.scalars());
}

void Bounds::find_active(const Graph& graph, std::span<double> gradient, std::span<double> right_hand_side) {
  held_ = 0;
  for (Item& item : items_) {
    item.value = *graph.vertex_pools()[item.pool]->entry(item.slot, item.bound.entry);
    item.gradient = gradient[item.scalar];
    const bool is_active = is_at_limit(item.bound, item.value, -item.gradient);
    item.state = is_active ? State::kActive : State::kFree;
    item.distance = 0;
    if (is_active) gradient[item.scalar] = right_hand_side[item.scalar] = 0;
    held_ += is_active;
  }
}

void Bounds::block(Item& item, double step) {
  item.state = State::kBlocked;
  item.distance = clipped_entry(item, step);
  item.outward = step;
  ++held_;
}

void Bounds::begin_step(detail::FunctionRef<double(std::uint32_t)> curvature) {
  forget_blocked();
  for (Item& item : items_) {
    item.releases = 0;
    if (item.state != State::kFree) continue;
    const double own = -item.gradient / curvature(item.scalar), possible = clipped_entry(item, own);
    if (possible != own && std::abs(possible) <= kAlmostAtOnce * std::abs(own)) block(item, own);
  }
}

void Bounds::hold(std::span<double> step) {
  for (Item& item : items_) {
    if (item.state != State::kFree) item.pull = std::exchange(step[item.scalar], 0.0) - item.distance;
  }
}

bool Bounds::revise(std::span<const double> step) {
  return find_blocked(step) || release_pulled();
}

bool Bounds::find_blocked(std::span<const double> step) {
  const std::size_t before = held_;
  for (Item& item : items_) {
    if (item.state != State::kFree) continue;
    const double whole = step[item.scalar], possible = clipped_entry(item, whole);
    if (possible != whole && std::abs(possible) <= kAlmostAtOnce * std::abs(whole)) block(item, whole);
  }
  return held_ > before;
}

bool Bounds::release_pulled() {
  constexpr int kMostReleases = 3;  // so that the rounds end
  const std::size_t before = held_;
  for (Item& item : items_) {
    if (item.state != State::kBlocked || !(item.pull * item.outward < 0) || item.releases == kMostReleases)
      continue;
    item.state = State::kFree;
    ++item.releases;
    --held_;
  }
  return held_ < before;
}

bool Bounds::stop_blocked() {
  bool moved = false;
  for (Item& item : items_) {
    if (item.state == State::kBlocked) moved |= std::exchange(item.distance, 0.0) != 0;
  }
  return moved;
}

bool Bounds::frees_active(detail::FunctionRef<double(std::uint32_t)> stiffness,
                          std::span<const double> diagonal, double decrease) const {
  return std::ranges::any_of(items_, [&](const Item& item) {
    if (item.state != State::kActive) return false;
    const double gradient = item.gradient - stiffness(item.scalar) * item.pull;
    return gradient * item.gradient < 0 && gradient * gradient > decrease * diagonal[item.scalar];
  });
}

void Bounds::forget_blocked() {
  for (Item& item : items_) {
    if (item.state != State::kBlocked) continue;
    item.state = State::kFree;
    --held_;
  }
}

/// The largest fraction of the step, at most 1, for which no entry leaves its limits.
double Bounds::longest_fraction(std::span<const double> step) const {
  double fraction = 1;
  for (const Item& item : items_) {
    const double whole = step[item.scalar], possible = clipped_entry(item, whole);
    if (possible != whole) fraction = std::min(fraction, possible / whole);
  }
  return fraction;
}

double Bounds::clipped_entry(const Item& item, double step) {
  return std::clamp(step, std::min(0.0, item.bound.lower - item.value),
                    std::max(0.0, item.bound.upper - item.value));
}

bool Bounds::clip(std::span<double> step) const {
  bool clips = false;
  for (const Item& item : items_) {
    double& entry = step[item.scalar];
    const double possible = clipped_entry(item, entry);
    clips |= possible != entry;
    entry = possible;
  }
  return clips;
}

/// Sets the steps of blocked entries to those that lead to their limits. Returns whether any is not zero.
bool Bounds::move_blocked(std::span<double> step) const {
  bool moves = false;
  for (const Item& item : items_) {
    if (item.state != State::kBlocked) continue;
    step[item.scalar] = item.distance;
    moves |= item.distance != 0;
  }
  return moves;
}

std::span<const double> Bounds::clipped(std::span<const double> step) {
  std::ranges::copy(step, scratch_.begin());
  clip(scratch_);
  return scratch_;
}

bool Bounds::keep_within(std::span<double> step,
                         detail::FunctionRef<double(std::span<const double>)> decrease) {
  const bool moves = move_blocked(step);
  const double fraction = longest_fraction(step);
  if (fraction == 1) return moves;
  std::ranges::transform(step, scratch_.begin(), [&](double entry) { return fraction * entry; });
  clip(step);
  if (!(decrease(step) >= decrease(scratch_))) std::ranges::copy(scratch_, step.begin());
  return true;
}

void Bounds::arrive(const Graph& graph, std::span<const double> step) const {
  constexpr double kWhole = 1 - 1e-15;  // the product of a step and a fraction is rounded
  for (const Item& item : items_) {
    detail::VertexPool& pool = *graph.vertex_pools()[item.pool];
    double& value = *pool.entry(item.slot, item.bound.entry);
    const double moved = step[item.scalar];
    const double limit = moved < 0 ? item.bound.lower : item.bound.upper;
    const bool arrives = moved != 0 && std::abs(moved) >= kWhole * std::abs(limit - item.value);
    if (arrives) value = limit;
    move_within(pool, item.slot, value, item.bound);
  }
}

void Bounds::report(const Graph& graph, const Plan& plan, std::vector<detail::ActiveBound>& out) const {
  out.clear();
  for (const Item& item : items_) {
    if (item.state != State::kActive) continue;
    const auto block = std::ranges::upper_bound(plan.structure.offset, item.scalar);
    const VertexRef vertex =
        plan.block_vertex[static_cast<std::size_t>(block - plan.structure.offset.begin()) - 1];
    const bool is_upper = item.gradient < 0;
    out.push_back({vertex, graph.id(vertex), item.bound.entry, is_upper,
                   is_upper ? item.bound.upper : item.bound.lower, 2 * std::abs(item.gradient)});
  }
}

}  // namespace boxplus
