// SPDX-License-Identifier: BSD-3-Clause
#include "bundle/ceres_bundle.h"

#include <ceres/ceres.h>
#include <ceres/rotation.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace boxplus::bench {
namespace {

/// The error of an observation for dual numbers, with the functions that Ceres recommends.
struct PixelError {
  double x, y;

  template <class T>
  bool operator()(const T* camera, const T* point, T* error) const {
    T p[3];
    ceres::AngleAxisRotatePoint(camera, point, p);
    for (int i = 0; i < 3; ++i) p[i] += camera[3 + i];
    const T u = -p[0] / p[2], v = -p[1] / p[2];
    const T r2 = u * u + v * v;
    const T scale = camera[6] * (1.0 + r2 * (camera[7] + camera[8] * r2));
    error[0] = scale * u - x;
    error[1] = scale * v - y;
    return true;
  }
};

/// The same error with Jacobians by hand.
class AnalyticPixelError final : public ceres::SizedCostFunction<2, 9, 3> {
 public:
  AnalyticPixelError(double x, double y) : x_(x), y_(y) {}

  bool Evaluate(double const* const* parameters, double* error, double** jacobians) const override {
    using Eigen::Matrix3d, Eigen::Vector3d;
    const double* camera = parameters[0];
    const Vector3d w(camera[0], camera[1], camera[2]),
        l(parameters[1][0], parameters[1][1], parameters[1][2]);
    const double angle2 = w.squaredNorm(), angle = std::sqrt(angle2);
    const bool tiny = angle2 < 1e-16;
    const double sine = std::sin(angle), cosine = std::cos(angle);
    const double a = tiny ? 1 : sine / angle, b = tiny ? 0.5 : (1 - cosine) / angle2,
                 c = tiny ? 1.0 / 6 : (angle - sine) / (angle2 * angle);
    const Vector3d cross = w.cross(l);
    const Vector3d rotated = l + a * cross + b * w.cross(cross);
    const Vector3d p = rotated + Vector3d(camera[3], camera[4], camera[5]);
    const double inverse = -1 / p[2], u = p[0] * inverse, v = p[1] * inverse, r2 = u * u + v * v;
    const double f = camera[6], k1 = camera[7], k2 = camera[8], lens = 1 + r2 * (k1 + k2 * r2);
    error[0] = f * lens * u - x_;
    error[1] = f * lens * v - y_;
    if (jacobians == nullptr) return true;
    const double slope = 2 * (k1 + 2 * k2 * r2);  // ∂lens/∂u = slope u
    const double uu = f * (lens + slope * u * u), uv = f * slope * u * v, vv = f * (lens + slope * v * v);
    Eigen::Matrix<double, 2, 3> J;
    J << uu * inverse, uv * inverse, (uu * u + uv * v) * inverse,  //
        uv * inverse, vv * inverse, (uv * u + vv * v) * inverse;
    const Matrix3d W = skew(w), W2 = W * W;
    if (jacobians[0] != nullptr) {
      Eigen::Map<Eigen::Matrix<double, 2, 9, Eigen::RowMajor>> out(jacobians[0]);
      const Matrix3d left = Matrix3d::Identity() + b * W + c * W2;  // the left Jacobian of SO(3)
      out.leftCols<3>() = -J * skew(rotated) * left;
      out.middleCols<3>(3) = J;
      out.col(6) << lens * u, lens * v;
      out.col(7) << f * r2 * u, f * r2 * v;
      out.col(8) << f * r2 * r2 * u, f * r2 * r2 * v;
    }
    if (jacobians[1] != nullptr) {
      Eigen::Map<Eigen::Matrix<double, 2, 3, Eigen::RowMajor>> out(jacobians[1]);
      out = J * (Matrix3d::Identity() + a * W + b * W2);
    }
    return true;
  }

 private:
  static Eigen::Matrix3d skew(const Eigen::Vector3d& v) {
    Eigen::Matrix3d out;
    out << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
    return out;
  }

  double x_, y_;
};

ceres::LinearSolverType type_of(CeresBundleSettings::Solver solver) {
  switch (solver) {
    case CeresBundleSettings::Solver::kDenseSchur:
      return ceres::DENSE_SCHUR;
    case CeresBundleSettings::Solver::kSparseSchur:
      return ceres::SPARSE_SCHUR;
    default:
      return ceres::ITERATIVE_SCHUR;
  }
}

/// Ends the run at the target, and remembers when and after how many iterations that was.
struct EndAtTarget final : ceres::IterationCallback {
  explicit EndAtTarget(double cost) : target(cost) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    seconds = summary.cumulative_time_in_seconds;
    iterations = summary.iteration;
    return summary.cost <= target ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }
  double target, seconds = 0;
  int iterations = 0;
};

}  // namespace

struct CeresBundle::Model {
  std::vector<std::array<double, 9>> cameras, first_cameras;
  std::vector<std::array<double, 3>> points, first_points;
  ceres::Problem problem;
};

CeresBundle::CeresBundle(const BundleProblem& problem, bool analytic) : model_(std::make_unique<Model>()) {
  Model& model = *model_;
  model.cameras = model.first_cameras = problem.cameras;
  model.points = model.first_points = problem.points;
  for (const auto& [camera, point, x, y] : problem.observations) {
    ceres::CostFunction* cost =
        analytic ? static_cast<ceres::CostFunction*>(new AnalyticPixelError(x, y))
                 : new ceres::AutoDiffCostFunction<PixelError, 2, 9, 3>(new PixelError{x, y});
    model.problem.AddResidualBlock(cost, nullptr, model.cameras[camera].data(), model.points[point].data());
  }
}

CeresBundle::~CeresBundle() = default;

BundleRun CeresBundle::run(CeresBundleSettings::Solver solver, int threads, double target) {
  Model& model = *model_;
  model.cameras = model.first_cameras;
  model.points = model.first_points;
  ceres::Solver::Options options;
  options.linear_solver_type = type_of(solver);
  options.max_num_iterations = 200;
  options.function_tolerance = 1e-12;
  options.gradient_tolerance = options.parameter_tolerance = 1e-14;
  options.logging_type = ceres::SILENT;
  options.num_threads = threads;
  if (solver == CeresBundleSettings::Solver::kIterativeSchur) {
    options.preconditioner_type = ceres::SCHUR_JACOBI;
    options.use_explicit_schur_complement = true;
  }
  options.linear_solver_ordering = std::make_shared<ceres::ParameterBlockOrdering>();
  for (auto& point : model.points) options.linear_solver_ordering->AddElementToGroup(point.data(), 0);
  for (auto& camera : model.cameras) options.linear_solver_ordering->AddElementToGroup(camera.data(), 1);
  EndAtTarget end(target);
  options.callbacks = {&end};
  ceres::Solver::Summary summary;
  ceres::Solve(options, &model.problem, &summary);
  BundleRun run;
  run.seconds = end.seconds;
  run.cost = summary.final_cost;
  run.iterations = end.iterations;
  run.linearize_s = summary.jacobian_evaluation_time_in_seconds;
  run.solve_s = summary.linear_solver_time_in_seconds;
  run.evaluate_s = summary.residual_evaluation_time_in_seconds;
  run.iterations_run = static_cast<int>(summary.iterations.size()) - 1;
  return run;
}

}  // namespace boxplus::bench
