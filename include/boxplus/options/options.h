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

#include "boxplus/gauge/gauge.h"
#include "boxplus/graph/handle.h"
#include "boxplus/linear/linear_solver_kind.h"

namespace boxplus {

class LinearSolver;

enum class AlgorithmKind : std::uint8_t {
  kAutomatic,  ///< dogleg, or Levenberg-Marquardt if vertices are eliminated or have bounds
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
  kChordal,       ///< the solution of a linear problem in relaxed rotations, positions and landmarks
  /// The current estimates, if no edge has a robust kernel, and a run from these estimates converges soon
  /// after a first step that lowers chi2 as the model predicts. Otherwise, the current estimates or the
  /// chordal guess, whichever has the lower chi2. If the first run seems to end in a local minimum, a second
  /// run starts from the other one of these two starts, and the better result is kept. The signs of a local
  /// minimum are: the first run does not converge; its final chi2 is above the initial chi2 of the other
  /// start; or it began at the current estimates, and its final chi2 is far above the chi2 that noise
  /// explains.
  kAutomatic
};
std::string_view to_string(Start start);

struct IterationRecord {
  int iteration = 0;  ///< its number, beginning with 1; if a start is given up, beginning with 1 again
  double chi2 = 0;    ///< after the iteration
  double chi2_decrease = 0;
  double predicted_decrease = 0;  ///< decrease of chi2 that the model predicts for the accepted step
  double step_max = 0;            ///< largest absolute entry of the accepted step
  double gradient_max = 0;        ///< largest absolute entry of the gradient before the step
  double lambda = 0;              ///< damping of the step; 0 if the algorithm has none
  double radius = 0;              ///< trust-region radius; 0 if the algorithm has none; infinite if unbounded
  int tries = 0;                  ///< number of evaluated steps
  int linear_iterations = 0;      ///< iterations of the linear solver, or steps of refinement
  double time_s = 0;              ///< time since the start of optimize()
};

struct Options {
  /// The matrix D in the damped system (H + λD) δ = −g of Levenberg-Marquardt: I or diag(H).
  enum class DampingScale : std::uint8_t { kIdentity, kDiagonal };

  AlgorithmKind algorithm = AlgorithmKind::kAutomatic;
  LinearSolverKind linear_solver = LinearSolverKind::kAutomatic;
  /// The precision of the Cholesky factor. With kGaussNewton, kAutomatic means double, because Gauss-Newton
  /// takes every step without a check. All other algorithms reject steps that do not lower chi2. With these
  /// algorithms, kAutomatic may use a factor in float and refine the step.
  Precision precision = Precision::kAutomatic;
  /// A custom solver, used instead of `linear_solver`; it may be inexact. An Optimizer calls its analyze()
  /// once per structure. Nothing else may use the solver while that Optimizer exists.
  std::shared_ptr<LinearSolver> custom_linear_solver = {};
  Start start = Start::kCurrent;
  GaugePolicy gauge = GaugePolicy::kFixFirst;
  SchurMode schur = SchurMode::kAutomatic;
  DampingScale damping = DampingScale::kDiagonal;

  /// The next options are the stopping criteria. A run stops as soon as one of them is met.
  /// Stops after this many iterations. If Start::kAutomatic runs from both starts, the iterations of both
  /// runs count. If it gives a start up after its first iterations (at most 9), they do not count.
  int max_iterations = 100;
  double cost_tolerance = 1e-10;  ///< stops when chi2 fell by less than this fraction of itself
  /// Stops when the decrease of chi2 is small compared with the noise variance, which is chi2 / (rows −
  /// unknowns) (1 if all Ω are correct). If chi2 falls by one noise variance, the estimates move by one
  /// standard deviation in one direction.
  ///
  /// The criterion is met if, in each of two consecutive iterations, the actual and the predicted decrease
  /// are at most this fraction of the noise variance, and at most 2e-7 of chi2. It is also met if, over ten
  /// consecutive iterations together, these decreases are at most ten times this fraction of the noise
  /// variance, and at most 5e-6 of chi2. With n > 100,000 unknowns, the fraction is multiplied by n /
  /// 100,000. 0 disables the criterion.
  double noise_tolerance = 2e-2;
  /// Stops when no entry of the step exceeds this fraction of its standard deviation, which is √(noise
  /// variance / Hᵢᵢ) if all other unknowns are known. So the criterion does not depend on units, and a vertex
  /// that comes from far away does not make the steps of others negligible.
  double step_tolerance = 1e-12;
  double gradient_tolerance = 0;  ///< stops when no entry of the gradient exceeds this
  /// Stops when this much time has passed, but not before the first step is accepted, so that runs with a
  /// short limit make progress. If the limit is 0 or negative, nothing is done. After the first step, the
  /// limit applies in every phase, and to initial guesses always: in 99 of 100 runs with the edges of this
  /// library and up to 100,000 poses, a run exceeds it by at most 1 ms or a tenth of it. `stop` applies in
  /// every phase from the beginning: planning, initial guess, linearization, linear solver. After `stop` is
  /// set, the AMD ordering may first run to its end (up to 110 ms for 100,000 poses).
  double time_limit_s = std::numeric_limits<double>::infinity();
  const std::atomic<bool>* stop = nullptr;  ///< stops when this flag becomes true; may be null
  /// Called after every iteration, including the last one. If it returns false, the run stops. If it changes
  /// the structure of the graph or optimizes the graph, InvalidArgument is thrown. It must not change
  /// estimates or weights, because the algorithm compares the next chi2 with the last one. (The callback may
  /// exchange kernels.)
  std::function<bool(const IterationRecord&)> callback = {};

  /// Levenberg-Marquardt: the first λ. 0 means 1e-5 or, if D = I, 1e-5 times the largest diagonal entry of H.
  double initial_lambda = 0;
  double initial_radius = 0;  ///< dogleg: first radius; 0: unbounded, so the first trial is Gauss-Newton
  /// The relative residual at which iterative linear solvers and iterative refinement stop (the forcing
  /// term). 0 means 0.01 if `linear_solver` is kPcg and vertices are eliminated, because rough steps of
  /// bundle adjustment are so much cheaper that the run ends sooner; otherwise, 0 means 1e-10. With a factor
  /// in float, values below 1e-6 are raised to 1e-6. If LinearSolverKind::kAutomatic chooses pcg, values
  /// below 0.1 are raised to 0.1.
  double linear_tolerance = 0;
  bool numeric_jacobians = false;  ///< differentiate every edge numerically
  bool triggs_correction = false;  ///< second-order term of robust kernels (see LinearizeOptions)

  /// LinearSolverKind::kAutomatic chooses pcg if a Cholesky factor would take more memory than this; 0: half
  /// of the machine's memory. (It also chooses pcg if a factorization would take far longer.)
  std::uint64_t max_factor_bytes = 0;
  int threads = 0;  ///< maximum number; 0: one per hardware thread. It does not affect results.
  int level = 0;    ///< edges of this level take part; if negative, all edges
  /// If not empty, only these vertices move, and only edges that contain at least one of them take part.
  std::vector<VertexRef> vertices = {};
  std::vector<EdgeRef> edges = {};  ///< if not empty, only these edges take part
};

}  // namespace boxplus
