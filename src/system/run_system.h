// SPDX-License-Identifier: BSD-3-Clause
// The System of a run of Optimizer.
#pragma once

#include <span>
#include <string_view>

#include "boxplus/linear/linear_statistics.h"
#include "boxplus/system/system.h"
#include "linearize/linearizer.h"
#include "system/trial.h"

namespace boxplus {

/// What descent, starts, finish_stiff, flat_directions and fill_report (in optimize/) ask of the System of a
/// run, besides what its algorithm asks. Trial steps are the same for every System. The functions with a body
/// suit a System without bounds, without gauge freedom and without steps in double-double.
class RunSystem : public System {
 public:
  /// How the System computes.
  struct Facts {
    std::string_view solver;
    LinearStatistics statistics;
    int workers = 1;
    /// The elimination order of the plan's blocks; empty if there is none.
    std::span<const std::uint32_t> elimination_order = {};
  };
  virtual Facts facts() const = 0;
  /// The vertices and edges that take part.
  virtual const Plan& plan() const = 0;
  /// The number of unknowns of this process. If several processes share the problem, each unknown belongs to
  /// one of them.
  virtual std::uint32_t unknowns() const { return plan().free_scalars(); }
  /// If several processes share the problem, replaces the entries of a vertex that several have by their sums
  /// in the process that owns the vertex, and by `elsewhere` in the others. `of_plan` has an entry for each
  /// scalar. All processes call this together.
  virtual void add_up(std::span<double> /*of_plan*/, double /*elsewhere*/) {}
  virtual const LinearizeOptions& linearize_options() const = 0;
  /// Computations end soon when the token is raised.
  virtual void set_stop(const StopToken& stop) = 0;
  /// scale() forgets the diagonals of earlier linearizations.
  virtual void forget_scale() {}

  // ---- Trial steps ----

  void accept() override { trial().accept(); }
  void reject() override { trial().reject(); }
  virtual Trial& trial() = 0;

  // ---- Gauge ----

  /// Returns false after a step has shown that edges measure a motion that the plan considers free.
  virtual bool gauge_is_free() const { return true; }
  /// The number of directions that are held because their pivots vanished (Plan::undetermined_blocks).
  virtual int held_directions() const { return 0; }
  /// Whether solve() damps H because of the gauge, even if λ = 0.
  virtual bool damps_gauge() const { return false; }
  /// The vertex whose block was not positive definite in the last failed solve().
  virtual VertexRef failed_vertex() const = 0;

  // ---- Bounds ----

  virtual bool has_bounds() const { return false; }
  /// Whether bounds shorten the last step of solve(), the step takes an entry to a limit, or it makes the
  /// gradient of an active entry point away from its limit. Then the next step may decrease chi2 much more.
  virtual bool changes_bounds() const { return false; }

  // ---- Steps in double-double ----

  /// If the factor in double loses a pivot, and some edge is stiff (linearize/stiff_edge.h), solve() computes
  /// the step in double-double, as long as such steps are affordable. After set_precise(true), it does so in
  /// every case, if the System can.
  virtual void set_precise(bool /*precise*/) {}
  /// The number of steps that were computed in double-double in this run.
  virtual int precise_steps() const { return 0; }
  /// The number of further steps in double-double that take about two seconds together with those of this
  /// run. 0 if a single one takes longer. Analyzes the structure if this has not been done before.
  virtual int affordable_precise_steps() { return 0; }
};

}  // namespace boxplus
