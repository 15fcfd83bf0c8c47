// SPDX-License-Identifier: BSD-3-Clause
// The error of a relative 3D pose for Ceres. It exists twice: as a functor for automatic differentiation, and
// as a cost function with analytic Jacobians. A pose has two parameter blocks, the position and the
// quaternion (x, y, z, w), as in Ceres's example pose_graph_3d.
#pragma once

#include <ceres/sized_cost_function.h>

#include <Eigen/Geometry>

#include "datasets/plain_graph.h"

namespace boxplus::bench {

/// The error S (t, s·q_v), with the translation t and the quaternion q of z⁻¹ xi⁻¹ xj, and the information
/// matrix SᵀS. The sign s = ±1 is chosen so that s·q_w ≥ 0.
struct SE3MotionError {
  explicit SE3MotionError(const PlainGraph::Motion& motion)
      : t_z(motion.z.data()), q_z(motion.z.data() + 3), root(motion.root_information.data()) {}

  template <class T>
  bool operator()(const T* ti, const T* qi, const T* tj, const T* qj, T* out) const {
    using Vector = Eigen::Matrix<T, 3, 1>;
    using Quaternion = Eigen::Quaternion<T>;
    const Quaternion from_i = Eigen::Map<const Quaternion>(qi).conjugate();
    const Quaternion from_z = q_z.conjugate().template cast<T>();
    const Vector t = from_i * Vector(Eigen::Map<const Vector>(tj) - Eigen::Map<const Vector>(ti));
    const Quaternion q = from_z * (from_i * Eigen::Map<const Quaternion>(qj));
    Eigen::Matrix<T, 6, 1> e;
    e << from_z * Vector(t - t_z.template cast<T>()), (q.w() < T(0) ? Vector(-q.vec()) : Vector(q.vec()));
    Eigen::Map<Eigen::Matrix<T, 6, 1>>{out} = root.template cast<T>() * e;
    return true;
  }

  Eigen::Vector3d t_z;
  Eigen::Quaterniond q_z;
  Eigen::Matrix<double, 6, 6, Eigen::RowMajor> root;
};

inline Eigen::Matrix3d cross_with(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return m;
}

/// The error of SE3MotionError, with analytic Jacobians. As in automatic differentiation, the Jacobian with
/// respect to a quaternion q = (v, w) has four columns. The derivatives follow from these formulas:
///   rotate(q*, d) = d − 2w (v × d) + 2 v × (v × d)
///     ⇒ ∂/∂v = 2 (w [d]× − [v × d]× − [v]× [d]×),  ∂/∂w = −2 v × d
///   vec(p q) = (p_w I + [p_v]×) q_v + p_v q_w
///   vec(p q* r) is the second formula for p and q* r, with q* = (−v, w) and
///     q* r = ((r_w I − [r_v]×) q*_v + r_v w, −r_vᵀ q*_v + r_w w).
class SE3MotionCost final : public ceres::SizedCostFunction<6, 3, 4, 3, 4> {
 public:
  explicit SE3MotionCost(const PlainGraph::Motion& motion)
      : error_(motion), R_z_transposed_(error_.q_z.conjugate().toRotationMatrix()) {}

  bool Evaluate(const double* const* x, double* residuals, double** jacobians) const override {
    const Eigen::Map<const Eigen::Quaterniond> qi(x[1]), qj(x[3]);
    const Eigen::Quaterniond from_z = error_.q_z.conjugate();
    const Eigen::Vector3d d =
        Eigen::Map<const Eigen::Vector3d>(x[2]) - Eigen::Map<const Eigen::Vector3d>(x[0]);
    const Eigen::Quaterniond to_i = from_z * qi.conjugate(), q = to_i * qj;
    const double sign = q.w() < 0 ? -1 : 1;
    Eigen::Matrix<double, 6, 1> e;
    e << from_z * Eigen::Vector3d(qi.conjugate() * d - error_.t_z), sign * q.vec();
    Eigen::Map<Eigen::Matrix<double, 6, 1>>{residuals} = error_.root * e;
    if (jacobians == nullptr) return true;
    if (jacobians[0] != nullptr || jacobians[2] != nullptr) {
      const Eigen::Matrix<double, 6, 3> J =
          error_.root.leftCols<3>() * (R_z_transposed_ * rotation_of_conjugate(qi));
      if (jacobians[0] != nullptr) Eigen::Map<PositionBlock>{jacobians[0]} = -J;
      if (jacobians[2] != nullptr) Eigen::Map<PositionBlock>{jacobians[2]} = J;
    }
    if (jacobians[1] != nullptr) {
      Eigen::Map<RotationBlock>{jacobians[1]}.noalias() =
          error_.root.leftCols<3>() * (R_z_transposed_ * derivative_of_rotation(qi, d)) +
          error_.root.rightCols<3>() * (sign * derivative_of_middle(from_z, qj));
    }
    if (jacobians[3] != nullptr) {
      Eigen::Map<RotationBlock>{jacobians[3]}.noalias() =
          error_.root.rightCols<3>() * (sign * left_product(to_i));
    }
    return true;
  }

 private:
  using PositionBlock = Eigen::Matrix<double, 6, 3, Eigen::RowMajor>;
  using RotationBlock = Eigen::Matrix<double, 6, 4, Eigen::RowMajor>;
  using ThreeByFour = Eigen::Matrix<double, 3, 4>;

  /// Returns the matrix of d ↦ rotate(q*, d), for a q whose norm need not be one.
  static Eigen::Matrix3d rotation_of_conjugate(const Eigen::Quaterniond& q) {
    return q.conjugate().toRotationMatrix();
  }

  /// Returns ∂ rotate(q*, d) / ∂ (v, w).
  static ThreeByFour derivative_of_rotation(const Eigen::Quaterniond& q, const Eigen::Vector3d& d) {
    const Eigen::Vector3d v = q.vec(), v_cross_d = v.cross(d);
    ThreeByFour J;
    J << 2 * ((q.w() * Eigen::Matrix3d::Identity() - cross_with(v)) * cross_with(d) - cross_with(v_cross_d)),
        -2 * v_cross_d;
    return J;
  }

  /// Returns the matrix of (v, w) ↦ vec(p q).
  static ThreeByFour left_product(const Eigen::Quaterniond& p) {
    ThreeByFour J;
    J << p.w() * Eigen::Matrix3d::Identity() + cross_with(p.vec()), p.vec();
    return J;
  }

  /// Returns the matrix of (v, w) ↦ vec(p q* r).
  static ThreeByFour derivative_of_middle(const Eigen::Quaterniond& p, const Eigen::Quaterniond& r) {
    Eigen::Matrix4d conjugate_times_r;
    conjugate_times_r << cross_with(r.vec()) - r.w() * Eigen::Matrix3d::Identity(), r.vec(),
        r.vec().transpose(), r.w();
    return left_product(p) * conjugate_times_r;
  }

  SE3MotionError error_;
  Eigen::Matrix3d R_z_transposed_;
};

}  // namespace boxplus::bench
