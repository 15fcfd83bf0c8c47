// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/ceres/ceres_peer.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

#include "datasets/ceres/se2_errors.h"
#include "datasets/ceres/se3_errors.h"
#include "datasets/median.h"

namespace boxplus::bench {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Records the time of the first iteration whose chi2 is at most the target, and ends the run there.
class ArrivalCallback final : public ceres::IterationCallback {
 public:
  explicit ArrivalCallback(double chi2) : cost_(chi2 / 2) {}

  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    if (!summary.step_is_successful || summary.cost > cost_) return ceres::SOLVER_CONTINUE;
    arrival_s = seconds_since(start_);
    return ceres::SOLVER_TERMINATE_SUCCESSFULLY;
  }

  double arrival_s = std::numeric_limits<double>::infinity();

 private:
  double cost_;
  Clock::time_point start_ = Clock::now();
};

ceres::Solver::Options options_of(const CeresSettings& settings, const CeresStop& stop) {
  using Strategy = CeresSettings::Strategy;
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.sparse_linear_algebra_library_type = ceres::SUITE_SPARSE;
  options.use_postordering = settings.post_ordering;
  options.trust_region_strategy_type =
      settings.strategy == Strategy::kLevenbergMarquardt ? ceres::LEVENBERG_MARQUARDT : ceres::DOGLEG;
  options.dogleg_type =
      settings.strategy == Strategy::kSubspaceDogleg ? ceres::SUBSPACE_DOGLEG : ceres::TRADITIONAL_DOGLEG;
  options.initial_trust_region_radius = settings.initial_radius;
  options.use_nonmonotonic_steps = settings.non_monotonic;
  options.num_threads = 1;
  options.max_num_iterations = stop.iterations;
  options.max_solver_time_in_seconds = stop.seconds;
  options.function_tolerance = stop.cost_tolerance;
  options.gradient_tolerance = 0;
  options.parameter_tolerance = 0;
  options.logging_type = ceres::SILENT;
  return options;
}

double median_iteration(const std::vector<ceres::IterationSummary>& iterations) {
  const int first = iterations.size() > 2 ? 2 : 1;
  std::vector<double> seconds;
  for (const auto& iteration : iterations) {
    if (iteration.iteration >= first) seconds.push_back(iteration.iteration_time_in_seconds);
  }
  return seconds.empty() ? 0 : median(std::move(seconds));
}

template <class Error, class Cost, int... sizes, class Measurement>
ceres::CostFunction* make_cost(const Measurement& measurement, CeresPeer::Jacobians jacobians) {
  if (jacobians == CeresPeer::Jacobians::kAnalytic) return new Cost(measurement);
  return new ceres::AutoDiffCostFunction<Error, sizes...>(new Error(measurement));
}

}  // namespace

std::span<const CeresSettings> all_ceres_settings() {
  using enum CeresSettings::Strategy;
  static constexpr std::array kAll{
      CeresSettings{"LM"},
      CeresSettings{.name = "LM, post-ordering", .post_ordering = true},
      CeresSettings{.name = "LM, radius 1e16", .initial_radius = 1e16},
      CeresSettings{.name = "LM, non-monotonic", .non_monotonic = true},
      CeresSettings{.name = "dogleg", .strategy = kDogleg},
      CeresSettings{.name = "subspace dogleg", .strategy = kSubspaceDogleg},
  };
  return kAll;
}

struct CeresPeer::Model {
  Model(const PlainGraph& graph, Jacobians jacobians)
      : start(&graph), poses(graph.poses), points(graph.points) {
    for (const auto& motion : graph.motions) add(motion, jacobians);
    for (const auto& observation : graph.observations) {
      problem.AddResidualBlock(make_cost<PointError, PointCost, 2, 3, 2>(observation, jacobians), nullptr,
                               pose(observation.pose), &points[2 * observation.point]);
    }
    for (std::size_t k = 0; k < graph.pose_is_fixed.size(); ++k) finish_pose(k, graph.pose_is_fixed[k]);
  }

  double* pose(std::size_t k) { return &poses[start->pose_size * k]; }

  void add(const PlainGraph::Motion& motion, Jacobians jacobians) {
    double *from = pose(motion.from), *to = pose(motion.to);
    if (start->pose_size == 3) {
      problem.AddResidualBlock(make_cost<SE2MotionError, SE2MotionCost, 3, 3, 3>(motion, jacobians), nullptr,
                               from, to);
    } else {
      problem.AddResidualBlock(make_cost<SE3MotionError, SE3MotionCost, 6, 3, 4, 3, 4>(motion, jacobians),
                               nullptr, from, from + 3, to, to + 3);
    }
  }

  void finish_pose(std::size_t k, bool fixed) {
    double* x = pose(k);
    if (!problem.HasParameterBlock(x)) return;
    if (fixed) problem.SetParameterBlockConstant(x);
    if (start->pose_size == 3) return;
    problem.SetManifold(x + 3, new ceres::EigenQuaternionManifold());
    if (fixed) problem.SetParameterBlockConstant(x + 3);
  }

  void reset() {
    std::copy(start->poses.begin(), start->poses.end(), poses.begin());
    std::copy(start->points.begin(), start->points.end(), points.begin());
  }

  const PlainGraph* start;
  std::vector<double> poses, points;
  ceres::Problem problem;
};

CeresPeer::CeresPeer(const PlainGraph& graph, Jacobians jacobians)
    : model_(std::make_unique<Model>(graph, jacobians)) {}
CeresPeer::~CeresPeer() = default;

const std::vector<double>& CeresPeer::poses() const {
  return model_->poses;
}
const std::vector<double>& CeresPeer::points() const {
  return model_->points;
}

CeresRun CeresPeer::solve(const CeresSettings& settings, const CeresStop& stop) {
  model_->reset();
  ceres::Solver::Options options = options_of(settings, stop);
  ceres::Solver::Summary summary;
  ArrivalCallback arrival(stop.chi2);
  options.callbacks.push_back(&arrival);
  const Clock::time_point begin = Clock::now();
  ceres::Solve(options, &model_->problem, &summary);
  CeresRun run;
  run.total_s = seconds_since(begin);
  run.arrival_s = arrival.arrival_s;
  run.chi2_initial = 2 * summary.initial_cost;
  run.chi2_final = 2 * summary.final_cost;
  run.iterations = static_cast<int>(summary.iterations.size()) - 1;
  run.jacobian_s =
      summary.jacobian_evaluation_time_in_seconds / std::max(1, summary.num_jacobian_evaluations);
  run.iteration_s = median_iteration(summary.iterations);
  run.gradient_max = summary.iterations.front().gradient_max_norm;
  return run;
}

std::string_view ceres_version() {
  return CERES_VERSION_STRING;
}

}  // namespace boxplus::bench
