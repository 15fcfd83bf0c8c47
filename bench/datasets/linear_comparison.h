// SPDX-License-Identifier: BSD-3-Clause
// Our block Cholesky against CHOLMOD on the H of a graph at its estimates.
#pragma once

#include <string>

#include "boxplus/graph/graph.h"

namespace boxplus::bench {

struct LinearFigures {
  double analyze_s = 0, factorize_s = 0, solve_s = 0;
  double flops = 0;  ///< useful operations of a factorization, with the contestant's own ordering
  double rate() const { return flops * 1e-9 / factorize_s; }
};

struct LinearComparison {
  std::uint32_t scalars = 0;
  LinearFigures ours, cholmod;  ///< ours in double; CHOLMOD's with the settings that factorize fastest
  /// Ours with its defaults: in float if that is predicted to be faster, with the solution refined to 1e-10.
  LinearFigures automatic;
  bool mixed = false;                      ///< `automatic` is in float
  double analyze_by_degree_s = 0;          ///< our analysis with minimum degree, as CHOLMOD's below
  bool dissected = false;                  ///< `ours` is ordered by nested dissection
  std::string cholmod_settings;            ///< their name
  double cholmod_amd_analyze_s = 0;        ///< cholmod_analyze() with AMD, in the form that factorizes faster
  double cholmod_block_amd_analyze_s = 0;  ///< the same with a given order of the blocks
  double largest_difference = 0;           ///< between the two solutions, relative to the largest entry
};

/// Throws std::runtime_error if a solver fails on H, or if the solutions differ.
LinearComparison run_linear_comparison(Graph& graph);

}  // namespace boxplus::bench
