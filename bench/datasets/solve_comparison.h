// SPDX-License-Identifier: BSD-3-Clause
// Compares whole solves of a graph from its estimates by boxplus and Ceres.
#pragma once

#include <limits>
#include <string>

#include "boxplus/graph/graph.h"

namespace boxplus::bench {

struct SolveFigures {
  double arrival_s = std::numeric_limits<double>::infinity();  ///< the time until chi2 was at most the target
  double linearize_s = 0;  ///< the time of one linearization; ours adds up H, Ceres only writes the Jacobian
  double iteration_s = 0;  ///< the median time of an iteration, without the first
  double iterations = 0;
  double chi2 = 0;  ///< chi2 at the end
  bool arrived() const { return arrival_s < std::numeric_limits<double>::infinity(); }
};

struct SolveComparison {
  double chi2_initial = 0;
  SolveFigures ours;            ///< boxplus from the estimates, with default options and one thread
  SolveFigures ours_automatic;  ///< boxplus with Start::kAutomatic: from the estimates or the chordal guess
  SolveFigures analytic, autodiff;  ///< Ceres with its fastest settings
  std::string ceres_settings;       ///< the name of these settings
  int ceres_settings_index = 0;
};

/// Throws std::runtime_error if boxplus and Ceres do not solve the same problem. Their values of chi2 at the
/// start, and the largest gradients from the two kinds of edges for Ceres, must have relative differences of
/// at most 1e-9.
SolveComparison run_solve_comparison(Graph& graph, double target);

}  // namespace boxplus::bench
