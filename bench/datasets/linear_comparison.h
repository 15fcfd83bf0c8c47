// SPDX-License-Identifier: BSD-3-Clause
// Our block Cholesky against CHOLMOD on the H of a graph at its estimates.
#pragma once

#include <string>

#include "boxplus/graph/graph.h"

namespace boxplus::bench {

struct LinearFigures {
  double analyze_s = 0, factorize_s = 0, solve_s = 0;
  double flops = 0;  ///< useful ones of a factorisation, with the contestant's own ordering
  double rate() const { return flops * 1e-9 / factorize_s; }
};

struct LinearDuel {
  std::uint32_t scalars = 0;
  LinearFigures ours, cholmod;  ///< ours in double; cholmod: of the settings that factorise fastest
  /// Ours as it is by default: in float where that is predicted to pay, the solution refined to 1e-10.
  LinearFigures automatic;
  bool mixed = false;                ///< whether that is in float
  double analyze_by_degree_s = 0;    ///< our analysis with minimum degree, as CHOLMOD's below
  bool dissected = false;            ///< whether `ours` is ordered by nested dissection
  std::string cholmod_settings;      ///< their name
  double cholmod_amd_analyze_s = 0;  ///< cholmod_analyze() with AMD, in the form that then factorises faster
  double cholmod_block_amd_analyze_s = 0;  ///< the same with the order of the blocks given
  double largest_difference = 0;           ///< of CHOLMOD's solution and ours, relative to the largest entry
};

/// Throws std::runtime_error where a solver fails on H, or the solutions differ.
LinearDuel run_linear_duel(Graph& graph);

}  // namespace boxplus::bench
