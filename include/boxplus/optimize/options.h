// SPDX-License-Identifier: BSD-3-Clause
// The options of optimize(). The defaults suit pose graphs and landmark maps.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string_view>
#include <vector>

#include "boxplus/graph/handle.h"
#include "boxplus/linear/linear_solver_kind.h"
#include "boxplus/linearize/gauge.h"

namespace boxplus {

class LinearSolver;

enum class AlgorithmKind : std::uint8_t {
  kAutomatic,  ///< dogleg, or Levenberg-Marquardt if vertices are eliminated
  kGaussNewton,
  kLevenbergMarquardt,
  kDogleg
};
std::string_view to_string(AlgorithmKind kind);

/// The estimates from which the iteration starts.
enum class Start : std::uint8_t {
  kCurrent,       ///< the current estimates
  kOdometry,      ///< chained along edges between consecutive ids
  kSpanningTree,  ///< propagated along shortest paths from the fixed vertices
  kChordal,       ///< one joint linear problem in relaxed rotations, positions and landmarks
  /// The current estimates, if their first step lowers chi2 as the model predicts, they converge soon, and no
  /// edge has a robust kernel. Otherwise the current estimates or the chordal guess, whichever has the lower
  /// chi2. A second run starts at the other of the two if the first run does not converge, if it ends above
  /// the chi2 at which the other begins, or if it began at the current estimates and ends far above the chi2
  /// that noise explains. The better result is kept.
  kAutomatic
};
std::string_view to_string(Start start);

struct IterationRecord {
  int iteration = 0;
  double chi2 = 0;  ///< after the iteration
  double chi2_decrease = 0;
  double predicted_decrease = 0;  ///< decrease of chi2 that the model predicts for the accepted step
  double step_max = 0;            ///< largest absolute entry of the accepted step
  double gradient_max = 0;        ///< largest absolute entry of the gradient before the step
  double lambda = 0;              ///< damping of the step; 0 if the algorithm has none
  double radius = 0;          ///< trust-region radius; 0 if the algorithm has none, infinite while unbounded
  int tries = 0;              ///< number of evaluated steps
  int linear_iterations = 0;  ///< iterations of the linear solver, or steps of refinement
  double time_s = 0;          ///< time since the start of optimize()
};

struct Options {
  /// The matrix D in the damped system (H + λD) δ = −g of Levenberg-Marquardt: I or diag(H).
  enum class DampingScale : std::uint8_t { kIdentity, kDiagonal };

  AlgorithmKind algorithm = AlgorithmKind::kAutomatic;
  LinearSolverKind linear_solver = LinearSolverKind::kAutomatic;
  /// The precision of the block Cholesky's factor. kAutomatic means double for kGaussNewton, which takes
  /// every step without a check. The other algorithms reject steps that do not lower chi2, so for them
  /// kAutomatic may use a factor in float and refine the step.
  Precision precision = Precision::kAutomatic;
  /// A custom solver, used instead of `linear_solver`; it may be inexact. An Optimizer calls its analyze()
  /// once per structure. Nothing else may use the solver while that Optimizer exists.
  std::shared_ptr<LinearSolver> custom_linear_solver = {};
  Start start = Start::kCurrent;
  GaugePolicy gauge = GaugePolicy::kFixFirst;
  SchurMode schur = SchurMode::kAutomatic;
  DampingScale damping = DampingScale::kDiagonal;

  /// The next options say when a run stops: as soon as one of these conditions holds.
  int max_iterations = 100;       ///< stops after this many iterations, counting all runs of one call
  double cost_tolerance = 1e-10;  ///< stops when chi2 fell by less than this fraction of itself
  /// Stops when each of two consecutive iterations lowers chi2 by less than this fraction of the noise
  /// variance, as predicted; or when ten consecutive iterations together lower it by less than ten times that
  /// amount. The noise variance is chi2 / (rows − unknowns), which is 1 if Ω is right. If chi2 falls by one
  /// noise variance, the estimates move by one standard deviation in one direction. The decrease must also be
  /// small relative to chi2: at most 2e-7 of chi2 in each of the two iterations, or at most 5e-6 of chi2 in
  /// the ten together. 0 disables this criterion.
  double noise_tolerance = 2e-2;
  /// Stops when no entry of the step exceeds this fraction of the largest step entry of the run.
  double step_tolerance = 1e-12;
  double gradient_tolerance = 0;  ///< stops when no entry of the gradient exceeds this
  /// Stops when this much time has passed.
  double time_limit_s = std::numeric_limits<double>::infinity();
  const std::atomic<bool>* stop = nullptr;  ///< stops when this flag becomes true; may be null
  /// The time limit and the flag apply in every phase: plan, starts, linearization, linear solvers. A run
  /// exceeds the limit by at most 1 ms or a tenth of it (in 99 of 100 runs, with the edges of this library,
  /// up to 100,000 poses). After the flag is set, AMD may first finish its ordering (up to 110 ms for 100,000
  /// poses).
  ///
  /// Called after every iteration, including the last one. If it returns false, the run stops. If it changes
  /// the structure of the graph or optimizes the graph, InvalidArgument is thrown. It must not change
  /// estimates or weights, because the next chi2 is compared with the last one. (It may exchange kernels.)
  std::function<bool(const IterationRecord&)> callback = {};

  /// Levenberg-Marquardt: the first λ. 0 means 1e-5 or, if D = I, 1e-5 times the largest diagonal entry of H.
  double initial_lambda = 0;
  double initial_radius = 0;  ///< dogleg: first radius; 0: unbounded, so the first trial is Gauss-Newton
  /// The relative residual at which iterative linear solvers and refinement stop (the forcing term). With a
  /// factor in float, at least 1e-6 is used. If kAutomatic falls back to pcg, at least 0.1 is used, because
  /// rough steps are so much cheaper that the run ends sooner.
  double linear_tolerance = 1e-10;
  bool numeric_jacobians = false;  ///< differentiate every edge numerically
  bool triggs_correction = false;  ///< second-order term of robust kernels (see LinearizeOptions)

  /// LinearSolverKind::kAutomatic chooses pcg if a Cholesky factor would take more memory than this; 0: half
  /// of the machine's memory. (It also chooses pcg if a factorization would take far longer.)
  std::uint64_t max_factor_bytes = 0;
  int threads = 0;  ///< maximum number; 0: one per hardware thread. It does not affect results.
  int level = 0;    ///< edges of this level take part; if negative, all edges
  /// If not empty, only these vertices move, and only edges that touch them take part.
  std::vector<VertexRef> vertices = {};
  std::vector<EdgeRef> edges = {};  ///< if not empty, only these edges take part
};

}  // namespace boxplus
