// SPDX-License-Identifier: BSD-3-Clause
// An optimizer of one graph. It keeps its plan, its memory and its algorithms between runs.
#pragma once

#include <initializer_list>
#include <memory>
#include <span>

#include "boxplus/covariance/covariance.h"
#include "boxplus/optimize/report.h"

namespace boxplus {

class Algorithm;

/// Minimizes F(x) = Σ ρ(eᵀΩe) over a graph's free vertices, in place.
///
///     Optimizer optimizer(graph, options);
///     Report first = optimizer.run();   // plans
///     Report second = optimizer.run();  // reuses the plan
///
/// The first run plans: it orders the vertices and lays out H. Later runs keep the plan if the structure of
/// the graph has not changed (Report::plan_reused). Otherwise they plan again. Estimates, measurements,
/// weights, kernels and enabled flags may change freely between runs. For a graph that grows with every run,
/// there is Smoother (boxplus/incremental/smoother.h).
///
/// A numerical failure is a status in the report, never an exception. The estimates are then the best that
/// were found. All methods throw InvalidArgument for misuse: stale handles in the options, two eliminated
/// vertices in one edge, options that are not numbers or not values of their enum, a run inside of a run on
/// the same graph, an optimizer that was moved from, and a graph that was moved, assigned to or destroyed
/// since the optimizer was made. If an error function throws, run() throws the same exception, and the
/// estimates are those before the current step.
///
/// Results have the same bits for any number of threads. Only one thread may use an Optimizer at a time.
class Optimizer {
 public:
  /// Keeps a reference to the graph, which must outlive the optimizer. Does not plan yet.
  explicit Optimizer(Graph& graph, Options options = {});
  ~Optimizer();
  Optimizer(Optimizer&&) noexcept;
  Optimizer& operator=(Optimizer&&) noexcept;

  const Options& options() const;
  /// Takes effect at the next run. The plan is kept unless one of these options changes: level, vertices,
  /// edges, gauge, threads, linear solver, Schur mode, precision, memory.
  void set_options(Options options);

  [[nodiscard]] Report run();
  /// Fills a report that the caller can reuse. Allocates no memory if the plan is reused and the error of
  /// every edge has a fixed size. (LinearSolverKind::kEigenSparse always allocates.)
  void run(Report& report);

  /// Runs a custom algorithm instead of Options::algorithm. If the algorithm needs exact steps, choose
  /// Precision::kDouble. With Precision::kAutomatic, the solver may compute a step from a factor in float and
  /// refine it only to a relative residual of 1e-6.
  [[nodiscard]] Report run(Algorithm& algorithm);
  void run(Algorithm& algorithm, Report& report);

  /// Covariances at the current estimates: boxplus::covariance() with the options of this optimizer, up to
  /// rounding. Uses the plan and the elimination order of the last run if the structure of the graph and the
  /// options have not changed since. Keeps the factor of H until H changes, so that further queries only read
  /// the part of the factor on the paths from `vertices` to the root of the elimination tree.
  ///
  /// The result is never out of date. If the graph contains only SE2, SE3, points, `Between` and observations
  /// of points, and no kernels, each query compares estimates, measurements and weights with those of the
  /// factor. Otherwise, it linearizes all edges and compares H.
  [[nodiscard]] Covariance covariance(std::span<const VertexRef> vertices) const;
  [[nodiscard]] Covariance covariance(std::initializer_list<VertexRef> vertices) const {
    return covariance(std::span(vertices.begin(), vertices.size()));
  }
  /// Likewise boxplus::marginal_covariances(). For all vertices, the first query after a change takes about
  /// as long as four factorizations. The inverse is kept with the factor.
  [[nodiscard]] Covariance marginal_covariances(std::span<const VertexRef> vertices) const;
  /// The cross-covariance of two vertices or, if a is b, the marginal covariance. If there is no covariance,
  /// throws Error with the reason.
  [[nodiscard]] Eigen::MatrixXd covariance(VertexRef a, VertexRef b) const {
    const VertexRef vertices[] = {a, b};
    return covariance(vertices).of(a, b);
  }

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Optimizes once, by a temporary Optimizer. To optimize the same graph several times, use an Optimizer,
/// because it reuses its plan.
Report optimize(Graph& graph, const Options& options = {});

}  // namespace boxplus
