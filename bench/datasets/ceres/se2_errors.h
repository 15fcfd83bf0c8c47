// SPDX-License-Identifier: BSD-3-Clause
// The errors of 2D poses and points for Ceres. Each error exists twice: as a functor for automatic
// differentiation, and as a cost function with analytic Jacobians. A pose is one parameter block (x, y, θ).
#pragma once

#include <ceres/sized_cost_function.h>

#include <Eigen/Core>
#include <cmath>

#include "datasets/plain_graph.h"

namespace boxplus::bench {

/// Wraps an angle to [−π, π).
template <class T>
T wrapped(const T& angle) {
  using std::floor;
  constexpr double kTurn = 2 * 3.14159265358979323846;
  return angle - kTurn * floor((angle + kTurn / 2) / kTurn);
}

/// The error S vec(z⁻¹ xi⁻¹ xj) of a relative pose z, with the information matrix SᵀS.
struct SE2MotionError {
  explicit SE2MotionError(const PlainGraph::Motion& motion)
      : z(motion.z.data()),
        root(motion.root_information.data()),
        cos_z(std::cos(z[2])),
        sin_z(std::sin(z[2])),
        z_body(cos_z * z[0] + sin_z * z[1], cos_z * z[1] - sin_z * z[0]) {}

  /// Computes S (Rᵀ (tj − ti) − Rzᵀ tz, θj − θi − θz), with R = R(θi + θz).
  template <class T>
  bool operator()(const T* xi, const T* xj, T* out) const {
    using std::cos;
    using std::sin;
    const T angle = xi[2] + z[2], c = cos(angle), s = sin(angle);
    const T dx = xj[0] - xi[0], dy = xj[1] - xi[1];
    const Eigen::Matrix<T, 3, 1> e(c * dx + s * dy - z_body[0], c * dy - s * dx - z_body[1],
                                   wrapped(T(xj[2] - angle)));
    Eigen::Map<Eigen::Matrix<T, 3, 1>>{out} = root.cast<T>() * e;
    return true;
  }

  Eigen::Vector3d z;
  Eigen::Matrix<double, 3, 3, Eigen::RowMajor> root;
  double cos_z, sin_z;
  Eigen::Vector2d z_body;
};

class SE2MotionCost final : public ceres::SizedCostFunction<3, 3, 3> {
 public:
  explicit SE2MotionCost(const PlainGraph::Motion& motion) : error_(motion) {}

  bool Evaluate(const double* const* x, double* residuals, double** jacobians) const override {
    using Block = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    const double angle = x[0][2] + error_.z[2], c = std::cos(angle), s = std::sin(angle);
    const double dx = x[1][0] - x[0][0], dy = x[1][1] - x[0][1];
    const Eigen::Vector3d e(c * dx + s * dy - error_.z_body[0], c * dy - s * dx - error_.z_body[1],
                            wrapped(x[1][2] - angle));
    Eigen::Map<Eigen::Vector3d>{residuals} = error_.root * e;
    if (jacobians == nullptr) return true;
    Block J;
    if (jacobians[0] != nullptr) {
      J << -c, -s, c * dy - s * dx, s, -c, -c * dx - s * dy, 0, 0, -1;
      Eigen::Map<Block>{jacobians[0]}.noalias() = error_.root * J;
    }
    if (jacobians[1] != nullptr) {
      J << c, s, 0, -s, c, 0, 0, 0, 1;
      Eigen::Map<Block>{jacobians[1]}.noalias() = error_.root * J;
    }
    return true;
  }

 private:
  SE2MotionError error_;
};

/// The error S (x⁻¹ l − z) of a point l that is observed from the pose x, with the information matrix SᵀS.
struct PointError {
  explicit PointError(const PlainGraph::Observation& observation)
      : z(observation.z.data()), root(observation.root_information.data()) {}

  template <class T>
  bool operator()(const T* x, const T* l, T* out) const {
    using std::cos;
    using std::sin;
    const T c = cos(x[2]), s = sin(x[2]), dx = l[0] - x[0], dy = l[1] - x[1];
    const Eigen::Matrix<T, 2, 1> e(c * dx + s * dy - z[0], c * dy - s * dx - z[1]);
    Eigen::Map<Eigen::Matrix<T, 2, 1>>{out} = root.cast<T>() * e;
    return true;
  }

  Eigen::Vector2d z;
  Eigen::Matrix<double, 2, 2, Eigen::RowMajor> root;
};

class PointCost final : public ceres::SizedCostFunction<2, 3, 2> {
 public:
  explicit PointCost(const PlainGraph::Observation& observation) : error_(observation) {}

  bool Evaluate(const double* const* x, double* residuals, double** jacobians) const override {
    const double c = std::cos(x[0][2]), s = std::sin(x[0][2]);
    const double dx = x[1][0] - x[0][0], dy = x[1][1] - x[0][1];
    const Eigen::Vector2d e(c * dx + s * dy - error_.z[0], c * dy - s * dx - error_.z[1]);
    Eigen::Map<Eigen::Vector2d>{residuals} = error_.root * e;
    if (jacobians == nullptr) return true;
    if (jacobians[0] != nullptr) {
      Eigen::Matrix<double, 2, 3> J;
      J << -c, -s, c * dy - s * dx, s, -c, -c * dx - s * dy;
      Eigen::Map<Eigen::Matrix<double, 2, 3, Eigen::RowMajor>>{jacobians[0]}.noalias() = error_.root * J;
    }
    if (jacobians[1] != nullptr) {
      Eigen::Matrix2d J;
      J << c, s, -s, c;
      Eigen::Map<Eigen::Matrix<double, 2, 2, Eigen::RowMajor>>{jacobians[1]}.noalias() = error_.root * J;
    }
    return true;
  }

 private:
  PointError error_;
};

}  // namespace boxplus::bench
