// SPDX-License-Identifier: BSD-3-Clause
// The equality constraints of a plan (types/constraint.h), and the method of multipliers.
#pragma once

#include <limits>
#include <vector>

#include "boxplus/optimize/report.h"
#include "plan/plan.h"

namespace boxplus {

/// A run minimizes F + Σ μ (c + s)ᵀΩ(c + s), where c is the error of a constraint. At its end, 2μΩ(c + s)
/// estimates the multipliers, and s ← c + s shifts the next run to them. If the violation |c| does not fall
/// fast, μ grows.
///
/// The graph has its own Ω and no shifts again when this object is destroyed.
class Constraints {
 public:
  /// Finds the enabled constraints of the plan. `graph` must outlive this object. Throws InvalidArgument if a
  /// constraint has a robust kernel.
  Constraints(Graph& graph, const Plan& plan);
  ~Constraints();
  Constraints(const Constraints&) = delete;
  Constraints& operator=(const Constraints&) = delete;

  bool empty() const { return items_.empty(); }
  /// Chooses the first weights. `chi2` is F with the constraints' own Ω.
  void begin(double chi2);
  /// Prepares the next run. Returns false if there is none, because the errors get no smaller.
  bool improve();
  /// Whether all constraints hold: the errors are at most 1e-9, or rounding errors of the estimates.
  bool hold() const { return excess_ <= 1; }
  /// Sets the results of the last run.
  void report(Report& report) const;

  /// Whether a graph has constraints, active or not.
  static bool exist_in(const Graph& graph);

 private:
  struct Item {
    EdgeRef edge;
    std::vector<double>* shift = nullptr;
    Eigen::MatrixXd information;
    Eigen::VectorXd multipliers = {};
  };

  void measure();
  Eigen::VectorXd tolerances(const EdgeRef& edge) const;
  void set_weight(double weight);

  Graph& graph_;
  std::vector<Item> items_;
  double weight_ = 1, violation_ = 0;
  double excess_ = 0;  // the largest error, as a multiple of its tolerance
  double best_ = std::numeric_limits<double>::infinity();  // the smallest violation
  int rounds_ = 0, in_vain_ = 0;
};

}  // namespace boxplus
