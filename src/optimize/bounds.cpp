// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/bounds.h"

#include <algorithm>
#include <cmath>

namespace boxplus {
namespace {

/// Whether the entry is at the limit towards which `direction` points.
bool is_at_limit(const detail::Bound& bound, double value, double direction) {
  return direction < 0 ? value <= bound.lower : direction > 0 && value >= bound.upper;
}

}  // namespace

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
  snap(graph);
  scratch_.resize(empty() ? 0 : plan.scalars());
}

void Bounds::find_active(const Graph& graph, std::span<double> gradient, std::span<double> right_hand_side) {
  held_ = 0;
  for (Item& item : items_) {
    item.value = *graph.vertex_pools()[item.pool]->entry(item.slot, item.bound.entry);
    item.gradient = gradient[item.scalar];
    const bool is_active = is_at_limit(item.bound, item.value, -item.gradient);
    item.state = is_active ? State::kActive : State::kFree;
    if (is_active) gradient[item.scalar] = right_hand_side[item.scalar] = 0;
    held_ += is_active;
  }
}

bool Bounds::find_blocked(std::span<const double> step) {
  constexpr double kAlmostAtOnce = 1e-2;
  const std::size_t before = held_;
  for (Item& item : items_) {
    if (item.state != State::kFree) continue;
    const double whole = step[item.scalar], possible = clipped_entry(item, whole);
    if (possible == whole || std::abs(possible) > kAlmostAtOnce * std::abs(whole)) continue;
    item.state = State::kBlocked;
    item.distance = possible;
    ++held_;
  }
  return held_ > before;
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
  const double fraction = longest_fraction(step);
  const bool moves = move_blocked(step);
  if (fraction == 1) return moves;
  std::ranges::transform(step, scratch_.begin(), [&](double entry) { return fraction * entry; });
  move_blocked(scratch_);
  clip(step);
  if (!(decrease(step) >= decrease(scratch_))) std::ranges::copy(scratch_, step.begin());
  return true;
}

void Bounds::snap(const Graph& graph) const {
  for (const Item& item : items_) {
    double& value = *graph.vertex_pools()[item.pool]->entry(item.slot, item.bound.entry);
    if (!std::isnan(value)) value = std::clamp(value, item.bound.lower, item.bound.upper);
  }
}

void Bounds::report(const Graph& graph, const Plan& plan, std::vector<Report::ActiveBound>& out) const {
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
