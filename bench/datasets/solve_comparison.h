// SPDX-License-Identifier: BSD-3-Clause
// Whole solves of a graph from its estimates: ours against Ceres.
#pragma once

#include <limits>
#include <string>

#include "boxplus/graph/graph.h"

namespace boxplus::bench {

struct SolveFigures {
  double arrival_s = std::numeric_limits<double>::infinity();  ///< until chi2 was at most the target
  double linearize_s = 0;  ///< of one linearisation; ours adds H, Ceres only writes the Jacobian
  double iteration_s = 0;  ///< the median iteration but for the first
  double iterations = 0;
  double chi2 = 0;  ///< where it ended
  bool arrived() const { return arrival_s < std::numeric_limits<double>::infinity(); }
};

struct SolveDuel {
  double chi2_initial = 0;
  SolveFigures ours;                ///< from the estimates, default options, one thread
  SolveFigures ours_automatic;      ///< Start::kAutomatic: the estimates or the chordal guess
  SolveFigures analytic, autodiff;  ///< Ceres with its fastest settings
  std::string ceres_settings;       ///< their name
  int ceres_settings_index = 0;
};

/// Throws std::runtime_error where the two do not solve the same problem: where their chi2 at the start
/// differ by more than 1e-9, or the gradients of Ceres's two kinds of edges.
SolveDuel run_solve_duel(Graph& graph, double target);

}  // namespace boxplus::bench
