// SPDX-License-Identifier: BSD-3-Clause
// Compares boxplus and Ceres when they optimize a whole graph from its estimates.
#pragma once

#include <limits>
#include <string>

#include "boxplus/graph/graph.h"

namespace boxplus::bench {

struct SolveFigures {
  double arrival_s = std::numeric_limits<double>::infinity();  ///< the time until chi2 was at most the target
  /// The time of one linearization. For boxplus, it includes the assembly of H; for Ceres, it does not.
  double linearize_s = 0;
  double iteration_s = 0;  ///< the median time of an iteration; the first iteration is not counted
  double iterations = 0;
  double chi2 = 0;  ///< chi2 at the end
  bool arrived() const { return arrival_s < std::numeric_limits<double>::infinity(); }
};

struct SolveComparison {
  double chi2_initial = 0;
  SolveFigures ours;            ///< boxplus from the estimates, with default options and one thread
  SolveFigures ours_automatic;  ///< boxplus with Start::kAutomatic: from the estimates or the chordal guess
  SolveFigures analytic, autodiff;  ///< Ceres with its fastest settings, for each kind of Jacobians
  std::string ceres_settings;       ///< the name of these settings
  int ceres_settings_index = 0;
};

/// `target` is the chi2 that the optimizers have to reach. Throws std::runtime_error if boxplus and Ceres do
/// not solve the same problem. At the start, chi2 of boxplus and Ceres, and the largest gradient entries of
/// Ceres with both kinds of Jacobians, may have relative differences of at most 1e-9.
SolveComparison run_solve_comparison(Graph& graph, double target);

}  // namespace boxplus::bench
