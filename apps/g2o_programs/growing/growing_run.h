// SPDX-License-Identifier: BSD-3-Clause
// What g2o_incremental and g2o_online share: their switches, their messages, and the service of the protocol.
#pragma once

#include <chrono>
#include <memory>

#include "common/arguments.h"
#include "growing/gnuplot.h"
#include "growing/incremental_solver.h"

namespace boxplus::programs {

struct GrowingOptions {
  IncrementalOptions solver;
  bool verbose = false, draws = false;
};

/// Declares -update, -v and -g.
void declare(Arguments& arguments, GrowingOptions& options);

/// Optimizes a graph while it grows, and tells the user about it.
class GrowingRun {
 public:
  /// `graph` must outlive this object.
  GrowingRun(Graph& graph, const GrowingOptions& options);

  IncrementalSolver& solver() { return solver_; }
  /// Does what is due (IncrementalSolver::solve()), prints a line if the user wants it, and draws.
  void solve();
  /// Iterates until it converges, and prints the size of the graph and the final chi2.
  void finish();

 private:
  void print(const char* work) const;

  Graph& graph_;
  GrowingOptions options_;
  IncrementalSolver solver_;
  std::unique_ptr<Gnuplot> gnuplot_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// Executes the commands of standard input as they arrive, and writes the answers to standard output. Throws
/// InputError for the first command that is wrong, and FileError if an answer cannot be written.
void serve_protocol(Graph& graph, GrowingRun& run);

}  // namespace boxplus::programs
