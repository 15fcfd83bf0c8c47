// SPDX-License-Identifier: BSD-3-Clause
#include "edges/ceres_icp.h"

#include <ceres/ceres.h>
#include <time.h>

#include <Eigen/Geometry>
#include <algorithm>

namespace boxplus::bench {
namespace {

/// The error of one Match. The pose has two parameter blocks, as in Ceres's example pose_graph_3d.
struct PlaneError {
  explicit PlaneError(const Match& match) : p(match.p.data()), q(match.q.data()), n(match.n.data()) {}

  template <class T>
  bool operator()(const T* translation, const T* rotation, T* out) const {
    const Eigen::Map<const Eigen::Matrix<T, 3, 1>> t(translation);
    const Eigen::Map<const Eigen::Quaternion<T>> r(rotation);
    const Eigen::Matrix<T, 3, 1> world = r * p.cast<T>() + t;
    out[0] = n.cast<T>().dot(world - q.cast<T>());
    return true;
  }

  Eigen::Vector3d p, q, n;
};

double seconds_of_thread() {
  timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Records the CPU time of this thread after each iteration.
struct Marks final : ceres::IterationCallback {
  std::vector<double> marks;
  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    marks.push_back(seconds_of_thread());
    return ceres::SOLVER_CONTINUE;
  }
};

}  // namespace

struct CeresIcp::Model {
  std::array<double, 7> start, pose;
  ceres::EigenQuaternionManifold quaternion;
  ceres::Problem problem{[] {
    ceres::Problem::Options options;
    options.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    return options;
  }()};
};

CeresIcp::CeresIcp(const IcpProblem& problem) : model_(std::make_unique<Model>()) {
  model_->start = model_->pose = problem.start;
  double* pose = model_->pose.data();
  for (const Match& match : problem.matches) {
    model_->problem.AddResidualBlock(
        new ceres::AutoDiffCostFunction<PlaneError, 1, 3, 4>(new PlaneError(match)), nullptr, pose, pose + 3);
  }
  model_->problem.SetManifold(pose + 3, &model_->quaternion);
}

CeresIcp::~CeresIcp() = default;

IcpRun CeresIcp::run(bool normal_equations) {
  model_->pose = model_->start;
  Marks marks;
  ceres::Solver::Options options;
  options.linear_solver_type = normal_equations ? ceres::DENSE_NORMAL_CHOLESKY : ceres::DENSE_QR;
  options.max_num_iterations = kIcpIterations;
  options.function_tolerance = options.gradient_tolerance = options.parameter_tolerance = 0;
  options.logging_type = ceres::SILENT;
  options.callbacks = {&marks};
  options.num_threads = 1;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &model_->problem, &summary);
  std::vector<double> seconds;
  for (std::size_t k = 2; k < marks.marks.size(); ++k) seconds.push_back(marks.marks[k] - marks.marks[k - 1]);
  std::sort(seconds.begin(), seconds.end());
  return {seconds.empty() ? 0 : seconds[seconds.size() / 2], 2 * summary.final_cost};
}

}  // namespace boxplus::bench
