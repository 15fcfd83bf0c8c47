// SPDX-License-Identifier: BSD-3-Clause
// Everything that can be asked of optimize(); the defaults do the right thing for pose graphs and landmark
// maps.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string_view>
#include <vector>

#include "boxplus/graph/handle.h"
#include "boxplus/linear/make_linear_solver.h"
#include "boxplus/linearize/gauge.h"

namespace boxplus {

enum class AlgorithmKind : std::uint8_t {
  kAutomatic,  ///< dogleg; Levenberg-Marquardt where vertices are eliminated
  kGaussNewton,
  kLevenbergMarquardt,
  kDogleg
};
std::string_view to_string(AlgorithmKind kind);

/// Where the iteration begins.
enum class Start : std::uint8_t {
  kCurrent,       ///< at the current estimates
  kOdometry,      ///< chained along edges between consecutive ids
  kSpanningTree,  ///< propagated along a minimum spanning tree from the fixed vertices
  kChordal,       ///< one joint linear problem in relaxed rotations, positions and landmarks
  /// At the current estimates where their first step does what the model promises and they arrive soon (never
  /// with robust kernels). Else at these or at the chordal guess, whichever has the lower chi2. If that run
  /// does not converge, ends above the other start's chi2 or, from the current estimates, far above what the
  /// noise explains, the other start is run too, and the better result is kept.
  kAutomatic
};
std::string_view to_string(Start start);

/// What λ multiplies in Levenberg-Marquardt.
enum class DampingScale : std::uint8_t { kIdentity, kDiagonal };

struct IterationRecord {
  int iteration = 0;
  double chi2 = 0;  ///< after the iteration
  double chi2_decrease = 0;
  double predicted_decrease = 0;  ///< of chi2, by the linear model, for the step taken
  double step_max = 0;            ///< largest entry of the step taken
  double gradient_max = 0;        ///< largest entry of the gradient before the step
  double lambda = 0;              ///< of the step; 0 if the algorithm has none
  double radius = 0;  ///< of the trust region; 0 if the algorithm has none, infinite before the first bound
  int tries = 0;      ///< steps evaluated
  int linear_iterations = 0;  ///< of an iterative linear solver, or steps of refinement
  double time_s = 0;          ///< since the start of optimize()
};

struct Options {
  AlgorithmKind algorithm = AlgorithmKind::kAutomatic;
  LinearSolverKind linear_solver = LinearSolverKind::kAutomatic;
  /// Of the block Cholesky's factor. kAutomatic: double for kGaussNewton, which takes every step as it comes;
  /// the other algorithms judge a step by what it gains, and bear one that is refined from float.
  Precision precision = Precision::kAutomatic;
  /// A custom solver, instead; it may be inexact. An Optimizer has it analyze each structure once. As long as
  /// that Optimizer lives, nothing else may use the solver.
  std::shared_ptr<LinearSolver> own_linear_solver = {};
  Start start = Start::kCurrent;
  GaugePolicy gauge = GaugePolicy::kFixFirst;
  SchurMode schur = SchurMode::kAutomatic;
  DampingScale damping = DampingScale::kDiagonal;

  /// Stop when …
  int max_iterations = 100;       ///< … there were so many iterations, of all runs together,
  double cost_tolerance = 1e-10;  ///< … chi2 fell by less than this fraction of itself,
  /// … two iterations in a row lowered chi2, and were predicted to, by less than this part of the noise's
  /// variance, or ten together by less than ten times that. The variance is chi2 / (rows − unknowns), which
  /// is 1 if Ω is right; a fall of chi2 by it moves the estimates by one standard deviation in one direction.
  /// The two fall by at most 2e-7 of chi2 each, the ten by 5e-6. 0: off,
  double noise_tolerance = 2e-2;
  double step_tolerance =
      1e-12;  ///< … no entry of the step is larger than this fraction of the run's largest,
  double gradient_tolerance = 0;  ///< … or none of the gradient is larger than this (in its own units).
  /// … so much time has passed,
  double time_limit_s = std::numeric_limits<double>::infinity();
  const std::atomic<bool>* stop = nullptr;  ///< … this becomes true.
  /// Both hold in every phase: plan, starts, linearization, linear solvers. A limit is exceeded by at most 1
  /// ms or a tenth of it (99 of 100 times, with the edges of this library, up to 100,000 poses); a flag also
  /// by the time that AMD takes to order the vertices (up to 110 ms at 100,000). The callback is called after
  /// every iteration, the last included; if it returns false, the run stops. If it changes the structure of
  /// the graph or optimizes it, InvalidArgument is thrown. It must not change estimates or weights, because
  /// chi2 is compared with that of the last iteration. (Kernels may be exchanged, to anneal them.)
  std::function<bool(const IterationRecord&)> callback = {};

  double initial_lambda =
      0;  ///< Levenberg-Marquardt; 0: 1e-5 times the largest diagonal entry of what is damped
  double initial_radius = 0;  ///< dogleg; 0: unbounded, so that the first trial is the Gauss-Newton step
  /// Forcing term of iterative linear solvers and of refinement: with a factor in float at least 1e-6; where
  /// kAutomatic had to take pcg, at least 0.1: rough steps are so much cheaper that they arrive sooner.
  double linear_tolerance = 1e-10;
  bool numeric_jacobians = false;  ///< differentiate every edge numerically
  bool triggs_correction = false;  ///< second-order term of robust kernels (see LinearizeOptions)

  /// LinearSolverKind::kAutomatic takes pcg where a Cholesky factor would take more memory than this; 0: than
  /// half of the machine's. (It also does where a factorisation would take far longer.)
  std::uint64_t max_factor_bytes = 0;
  int threads = 0;  ///< at most; 0: one per hardware thread. Results do not depend on it.
  int level = 0;    ///< edges of this level take part; negative: all
  std::vector<VertexRef> vertices =
      {};                           ///< not empty: only these move, and only edges that touch them take part
  std::vector<EdgeRef> edges = {};  ///< not empty: only these take part
};

}  // namespace boxplus
