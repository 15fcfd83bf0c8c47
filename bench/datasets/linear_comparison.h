// SPDX-License-Identifier: BSD-3-Clause
// Compares our block Cholesky solver with CHOLMOD on the H of a graph at its estimates.
#pragma once

#include <string>

#include "boxplus/graph/graph.h"

namespace boxplus::bench {

struct LinearFigures {
  double analyze_s = 0, factorize_s = 0, solve_s = 0;
  double flops = 0;  ///< the useful operations of a factorization, with the ordering of the contestant
  double rate() const { return flops * 1e-9 / factorize_s; }
};

struct LinearComparison {
  std::uint32_t scalars = 0;
  LinearFigures ours;     ///< our solver in double
  LinearFigures cholmod;  ///< CHOLMOD with the settings that factorize fastest
  /// Our solver with default options: in float if that is predicted to be faster, with the solution refined
  /// to 1e-10.
  LinearFigures automatic;
  bool mixed = false;              ///< true if `automatic` is in float
  double analyze_by_degree_s = 0;  ///< the time of our analysis with minimum degree, for comparison with AMD
  bool dissected = false;          ///< true if `ours` is ordered by nested dissection
  std::string cholmod_settings;    ///< the name of the settings of `cholmod`
  /// The time of cholmod_analyze() with AMD, in the form (simplicial or supernodal) that factorizes faster.
  double cholmod_amd_analyze_s = 0;
  double cholmod_block_amd_analyze_s = 0;  ///< the same time with AMD on the blocks
  double largest_difference = 0;           ///< the largest relative difference between two solutions
};

/// Throws std::runtime_error if a solver fails on H, or if the solutions differ.
LinearComparison run_linear_comparison(Graph& graph);

}  // namespace boxplus::bench
