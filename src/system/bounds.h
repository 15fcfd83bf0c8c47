// SPDX-License-Identifier: BSD-3-Clause
// The bounds of a plan's vertices (Graph::set_bounds()).
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "boxplus/base/function_ref.h"
#include "boxplus/system/active_bound.h"
#include "plan/plan.h"

namespace boxplus {

/// Keeps steps within bounds, as a projected Newton method does (Bertsekas, "Projected Newton methods for
/// optimization problems with simple constraints", 1982).
///
/// An entry is active if it is at a limit and the gradient points inward, so that F would fall only beyond
/// the limit. Active entries do not move, and their gradient counts as zero, so that the gradient vanishes at
/// a minimum. An entry is blocked if it is not active, but a step would take it beyond a limit almost at
/// once; it then goes to this limit. Active and blocked entries are held while the step of the others is
/// computed.
class Bounds {
 public:
  /// Reads the bounds of the plan's vertices.
  void read(const Graph& graph, const Plan& plan);
  bool empty() const { return items_.empty(); }

  /// Finds the active entries at the current estimates, and sets their entries of both vectors to zero.
  void find_active(const Graph& graph, std::span<double> gradient, std::span<double> right_hand_side);
  /// To be called before the first solve for a step. Blocks the entries that are so close to a limit that
  /// their own gradient leads them there almost at once. curvature(scalar) is the diagonal entry of H + λD.
  void begin_step(detail::FunctionRef<double(std::uint32_t)> curvature);
  /// Calls f(scalar, distance) for each blocked entry, with the distance to its limit.
  template <class F>
  void for_each_blocked(F&& f) const {
    for (const Item& item : items_) {
      if (item.state == State::kBlocked) f(item.scalar, item.distance);
    }
  }
  /// Sets the steps of held entries to zero. They must be the solution with large diagonal entries that pull
  /// held entries to their distances; the rest says to which side the model of chi2 pulls them.
  void hold(std::span<double> step);
  /// Finds the entries that block a step. If there are no new ones, releases blocked entries that the model
  /// pulls away from their limits. Returns false if there are none of these, either.
  bool revise(std::span<const double> step);
  /// From now on, blocked entries do not move. Returns whether any did.
  bool stop_blocked();
  /// Whether the model of chi2 pulls an active entry away from its limit after the step, so that the entry
  /// can lower chi2 by more than `decrease`. stiffness(scalar) is what was added to H to hold the entry.
  bool frees_active(detail::FunctionRef<double(std::uint32_t)> stiffness, std::span<const double> diagonal,
                    double decrease) const;
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
  /// limits, shortens it: either only the entries that do so, or the whole step, which lowers the model of
  /// chi2 if the step does. Takes the better of both, by means of decrease(step), the decrease of the model.
  /// Returns whether the step has changed.
  bool keep_within(std::span<double> step, detail::FunctionRef<double(std::span<const double>)> decrease);
  /// To be called after x ← x ⊞ step with a clipped step: entries that the step leads to their limits, up to
  /// rounding errors, are then exactly there.
  void arrive(const Graph& graph, std::span<const double> step) const;

  /// The active entries, in the order of the plan.
  void report(const Graph& graph, const Plan& plan, std::vector<detail::ActiveBound>& out) const;

 private:
  enum class State : std::uint8_t { kFree, kActive, kBlocked };
  struct Item {
    std::uint32_t pool = 0, slot = 0, scalar = 0;
    detail::Bound bound;
    double value = 0;     // at the last find_active()
    double gradient = 0;  // of F / 2, at the last find_active()
    double distance = 0;  // of a blocked entry: from its value to its limit
    double outward = 0;   // of a blocked entry: a number with the sign of the direction to its limit
    double pull = 0;      // of a held entry: what hold() has set to zero
    int releases = 0;     // since begin_step()
    State state = State::kFree;
  };

  static double clipped_entry(const Item& item, double step);
  double longest_fraction(std::span<const double> step) const;
  bool move_blocked(std::span<double> step) const;
  void block(Item& item, double step);
  bool find_blocked(std::span<const double> step);
  bool release_pulled();
  void forget_blocked();

  std::vector<Item> items_;
  std::size_t held_ = 0;
  std::vector<double> scratch_;  // a step; empty if there are no bounds
};

/// Moves the estimates that are outside of their bounds to the nearest limit: of these vertices or, if there
/// are none, of all vertices. Fixed vertices and fixed directions keep their estimates.
void move_within_bounds(const Graph& graph, std::span<const VertexRef> vertices);

}  // namespace boxplus
