// SPDX-License-Identifier: BSD-3-Clause
// The interface through which an algorithm accesses the problem.
#pragma once

#include <cstdint>
#include <span>

#include "boxplus/linear/linear_solver.h"
#include "boxplus/options/options.h"

namespace boxplus {

struct StepDamping {
  double lambda = 0;
  Options::DampingScale scale = Options::DampingScale::kIdentity;
  bool operator==(const StepDamping&) const = default;
};

struct [[nodiscard]] StepResult {
  LinearStatus status = LinearStatus::kOk;
  int linear_iterations = 0;
  bool exact = false;  ///< SolveResult::exact; if true, the step δ satisfies δᵀ(H + λD)δ = −gᵀδ
};

/// The cost F and its quadratic model around the current estimates: F(x ⊞ δ) ≈ F + 2 gᵀδ + δᵀHδ.
///
/// An iteration calls linearize(), which makes the model, and then solve(), curvature() and try_step() any
/// number of times, in any order. It ends each try_step() by a call of accept() or reject(); until then, it
/// may call only chi2(), gradient() and diagonal(). After accept(), the model belongs to earlier estimates.
/// Then call linearize() before the next solve(), curvature() or try_step(). If the order of the calls is
/// wrong, or a vector has the wrong size, the functions throw InvalidArgument and change nothing.
///
/// The results of solve() and curvature() depend only on the model and on the arguments. If they are called
/// again, also after a rejected step, they have the same bits. (There is one exception: if the linear solver
/// falls back from float to double, later steps are more accurate than earlier ones.) Only try_step() and
/// reject() may change estimates between linearize() and accept(), because solve() and curvature() may
/// compute Jacobians again. Spans stay valid until the next linearize().
class System {
 public:
  virtual ~System() = default;
  /// F at the current estimates.
  virtual double chi2() = 0;
  /// Announces the damping of the first solve() after the next linearize(). This saves time if the system can
  /// begin to solve while it linearizes. The results are the same.
  virtual void expect(const StepDamping& /*damping*/) {}
  /// Computes g and H. Returns false if they are not finite. Then solve() returns kNotFinite.
  virtual bool linearize() = 0;
  /// Whether Options::stop or time_limit_s stopped the last call of linearize(), try_step() or chi2(). If
  /// stopped, linearize() returns false, and then solve() returns kStopped; try_step() and chi2() return NaN.
  /// After a stopped try_step(), call reject().
  virtual bool stopped() const { return false; }
  virtual std::span<const double> gradient() const = 0;
  virtual std::span<const double> diagonal() const = 0;
  /// The D of solve(), which also scales trust regions. It is the diagonal of H, except for entries that have
  /// become much smaller during the run. If these were scaled by the diagonal, the steps of others would
  /// become as short as theirs are long (Moré, "The Levenberg-Marquardt algorithm: implementation and
  /// theory", 1978).
  virtual std::span<const double> scale() const { return diagonal(); }
  /// Returns dᵀHd, or NaN if it is stopped.
  virtual double curvature(std::span<const double> d) = 0;
  /// Solves (H + λD) step = −g. `step` has as many entries as the gradient.
  virtual StepResult solve(const StepDamping& damping, std::span<double> step) = 0;
  /// Shortens the entries of a step that leave bounds (Graph::set_bounds()), as try_step() does. Returns
  /// whether there are any. Steps of solve() have none.
  virtual bool clip(std::span<double> /*step*/) const { return false; }
  /// Sets x ← x ⊞ step, and returns F at the new x.
  virtual double try_step(std::span<const double> step) = 0;
  virtual void accept() = 0;
  virtual void reject() = 0;

  // ---- Several processes ----
  //
  // If processes share a problem, each has a System with its own entries of all vectors, calls the same
  // functions in the same order, and gets the same results, except for the entries. So an algorithm must pass
  // every sum and every maximum over the entries of a vector to these functions, and decide by their results.

  /// The sum of what the processes pass, in an order that does not change.
  virtual double sum(double of_entries) const { return of_entries; }
  /// The largest value that a process passes. If one is NaN, so may be the result, but of all processes.
  virtual double max(double of_entries) const { return of_entries; }
};

}  // namespace boxplus
