// SPDX-License-Identifier: BSD-3-Clause
// Optimization of a graph of which each process of an MPI communicator has a part. Programs link
// boxplus::mpi.
#pragma once

#include <mpi.h>

#include <cstdint>
#include <functional>
#include <memory>

#include "boxplus/graph/graph.h"
#include "boxplus/optimize/report.h"
#include "boxplus/options/options.h"

namespace boxplus {

/// The report of the whole problem, which is the same in every process, but for the times, for the types of
/// edges in Report::jacobians, which are those of the process, and for what is named below.
struct [[nodiscard]] DistributedReport : Report {
  int processes = 1;
  /// The vertices that are not eliminated. Every process has a copy of their system, unless the solver
  /// divides it.
  std::uint32_t kept = 0;
  /// The numbers of edges, of eliminated vertices and of kept vertices that take part in this process.
  std::uint32_t own_edges = 0, own_eliminated = 0, own_kept = 0;
  /// The bytes that this process has sent during the run, and those of all processes, without those that a
  /// solver sends if it divides the system.
  std::uint64_t sent_bytes = 0, all_sent_bytes = 0;
};

/// Minimizes the cost of a graph that is divided among the processes of a communicator. It takes the steps of
/// Optimizer, up to rounding errors: each process linearizes its edges and eliminates its own vertices. What
/// they contribute to the system of the kept vertices is added in the order of ranks, every process solves
/// the same system, and computes the steps of its eliminated vertices. So runs with equal numbers of
/// processes have the same bits.
///
/// The graph of a process has a part of the edges, and the vertices of these edges:
/// - Each edge is in the graph of one process.
/// - An eliminated vertex (Graph::set_eliminated()) is in the graph of one process, with all of its edges.
/// - Each other vertex is in the graph of every process that has an edge of it, with the same id, the same
///   estimate and the same flags. At the end, its estimates are again the same.
/// - If an edge has several eliminated vertices, the optimizer throws, as in one process.
///
/// Every process calls the same functions in the same order, with the same options, but for threads, stop,
/// callback and lists of vertices and edges. Options::threads 0 divides the hardware threads of a machine
/// among its processes. If a function throws in one process, it throws in all of them, with the message of
/// the process with the lowest rank that has failed. Errors of MPI itself, such as a process that ended, are
/// left to the error handler of the communicator, which ends all processes unless the program changes it. So
/// is memory that runs out in one process within a solver that divides the system, where others wait for it.
///
/// Options::custom_linear_solver may be a solver that needs contributions, such as that of
/// boxplus/petsc/make_divided_petsc_solver.h. Then each process has a part of the system.
///
/// Limits: at most kMostKept vertices are kept, unless the solver divides their system. Initial guesses need
/// the whole graph (run()). Gauge freedom is not searched for: fix a vertex, or H is damped a little if a
/// pivot vanishes, as by GaugePolicy::kDamp; Report::degrees_of_freedom counts it as determined. The time
/// limit and Options::stop end a run between two iterations. Reports have no rejected edges and no findings.
/// Steps are not computed with 32 digits. Bounds, constraints, GaugePolicy::kError, SchurMode::kImplicit, and
/// solvers that need no matrix are refused.
class DistributedOptimizer {
 public:
  static constexpr std::uint32_t kMostKept = 20000;

  /// MPI must have started. `communicator` is duplicated, and freed by the destructor: destroy the optimizer
  /// before MPI ends. `graph` must outlive the optimizer. Collective.
  DistributedOptimizer(MPI_Comm communicator, Graph& graph, Options options = {});
  ~DistributedOptimizer();
  DistributedOptimizer(DistributedOptimizer&&) noexcept;
  DistributedOptimizer& operator=(DistributedOptimizer&&) noexcept;

  /// Replaces the estimates of the graph by an initial guess. Returns false, in all processes, if there is
  /// none; the estimates are then as they were.
  using Guess = std::function<bool(Start)>;

  /// Makes a plan, and minimizes from the start that Options::start selects. `guess` makes the guesses that
  /// it needs; without it, there are none. Collective.
  DistributedReport run(const Guess& guess = {});

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace boxplus
