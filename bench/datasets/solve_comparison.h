// SPDX-License-Identifier: BSD-3-Clause
// Whole solves of a graph from its estimates: boxplus and Ceres.
#pragma once

#include <limits>
#include <string>

#include "boxplus/graph/graph.h"

namespace boxplus::bench {

struct SolveFigures {
  double arrival_s = std::numeric_limits<double>::infinity();  ///< until chi2 was at most the target
  double linearize_s = 0;  ///< for one linearization; ours adds up H, Ceres only writes the Jacobian
  double iteration_s = 0;  ///< the median iteration without the first
  double iterations = 0;
  double chi2 = 0;  ///< at the end
  bool arrived() const { return arrival_s < std::numeric_limits<double>::infinity(); }
};

struct SolveComparison {
  double chi2_initial = 0;
  SolveFigures ours;                ///< from the estimates, default options, one thread
  SolveFigures ours_automatic;      ///< Start::kAutomatic: the estimates or the chordal guess
  SolveFigures analytic, autodiff;  ///< Ceres with its fastest settings
  std::string ceres_settings;       ///< their name
  int ceres_settings_index = 0;
};

/// Throws std::runtime_error if the two do not solve the same problem: if chi2 at the start differs by more
/// than 1e-9, or the gradients of Ceres's two kinds of edges do.
SolveComparison run_solve_comparison(Graph& graph, double target);

}  // namespace boxplus::bench
