// SPDX-License-Identifier: BSD-3-Clause
// The bounds of a plan's vertices (Graph::set_bounds()).
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "boxplus/base/function_ref.h"
#include "boxplus/optimize/report.h"
#include "boxplus/plan/plan.h"

namespace boxplus {

/// Keeps steps within bounds, as a projected Newton method does (Bertsekas, "Projected Newton methods for
/// optimization problems with simple constraints", 1982).
///
/// An entry is active if it is at a limit and the gradient points inward, so that F would fall only beyond
/// the limit. Active entries do not move, and their gradient counts as zero, so that the gradient vanishes at
/// a minimum. An entry is blocked if it is at a limit and not active, but a step points outward. Active and
/// blocked entries are held.
class Bounds {
 public:
  /// Reads the bounds of the plan's vertices, and moves entries that are outside to the nearest limit.
  void read(const Graph& graph, const Plan& plan);
  bool empty() const { return items_.empty(); }

  /// Finds the active entries at the current estimates, and sets their entries of both vectors to zero.
  void find_active(const Graph& graph, std::span<double> gradient, std::span<double> right_hand_side);
  /// Finds the entries that block a step. Returns false if all of them are already held.
  bool find_blocked(std::span<const double> step);
  void forget_blocked();
  bool holds_any() const { return held_ > 0; }
  /// Calls f(scalar) for each held entry.
  template <class F>
  void for_each_held(F&& f) const {
    for (const Item& item : items_) {
      if (item.state != State::kFree) f(item.scalar);
    }
  }

  /// Shortens each entry of the step that leaves its limits. Returns whether there are any.
  bool clip(std::span<double> step) const;
  /// A copy of the step after clip(), valid until the next call of a function that is not const.
  std::span<const double> clipped(std::span<const double> step);
  /// Sets the steps of blocked entries to those that lead to their limits. If the step then leaves the
  /// limits, shortens it: either only the entries that do so, or the whole step, which always lowers the
  /// model of chi2. Takes the better of both, by means of decrease(step), the decrease of the model. Returns
  /// whether the step has changed.
  bool keep_within(std::span<double> step, detail::FunctionRef<double(std::span<const double>)> decrease);
  /// To be called after x ← x ⊞ step with a clipped step: entries that are outside by rounding errors move to
  /// their limits, so that they are exactly there.
  void snap(const Graph& graph) const;

  /// The active entries, in the order of the plan.
  void report(const Graph& graph, const Plan& plan, std::vector<Report::ActiveBound>& out) const;

 private:
  enum class State : std::uint8_t { kFree, kActive, kBlocked };
  struct Item {
    std::uint32_t pool = 0, slot = 0, scalar = 0;
    detail::Bound bound;
    double value = 0;     // at the last find_active()
    double gradient = 0;  // of F / 2, at the last find_active()
    double distance = 0;  // of a blocked entry: from its value to its limit
    State state = State::kFree;
  };

  static double clipped_entry(const Item& item, double step);
  double longest_fraction(std::span<const double> step) const;
  bool move_blocked(std::span<double> step) const;

  std::vector<Item> items_;
  std::size_t held_ = 0;
  std::vector<double> scratch_;  // a step; empty if there are no bounds
};

}  // namespace boxplus
