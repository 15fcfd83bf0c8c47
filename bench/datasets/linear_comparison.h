// SPDX-License-Identifier: BSD-3-Clause
// Compares the block Cholesky solver of boxplus with CHOLMOD. The matrix is H = Σ JᵀΩJ of a graph at its
// estimates.
#pragma once

#include <string>

#include "boxplus/graph/graph.h"

namespace boxplus::bench {

struct LinearFigures {
  double analyze_s = 0, factorize_s = 0, solve_s = 0;
  /// The floating-point operations of a factorization with the solver's own ordering, not counting operations
  /// on the zeros that supernodes add.
  double flops = 0;
  double rate() const { return flops * 1e-9 / factorize_s; }
};

struct LinearComparison {
  std::uint32_t scalars = 0;
  LinearFigures ours;     ///< boxplus in double
  LinearFigures cholmod;  ///< CHOLMOD with the settings that factorize fastest
  /// boxplus with default options. If it is predicted to be faster, boxplus factorizes in float, and refines
  /// the solution in double to a residual of 1e-10.
  LinearFigures automatic;
  bool mixed = false;              ///< true if `automatic` factorizes in float
  double analyze_by_degree_s = 0;  ///< the time of the analysis by boxplus with minimum degree
  bool dissected = false;          ///< true if `ours` uses a nested dissection ordering
  std::string cholmod_settings;    ///< the name of the settings of `cholmod`
  /// The time of CHOLMOD's analysis with AMD: simplicial or supernodal, whichever factorizes faster.
  double cholmod_amd_analyze_s = 0;
  double cholmod_block_amd_analyze_s = 0;  ///< the same, if AMD orders blocks instead of scalars
  double largest_difference = 0;           ///< the largest relative difference between two solutions
};

/// Throws std::runtime_error if a solver fails on H, or if the solutions differ.
LinearComparison run_linear_comparison(Graph& graph);

}  // namespace boxplus::bench
