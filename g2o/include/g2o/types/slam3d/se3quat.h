// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SE3QUAT_H_
#define G2O_SE3QUAT_H_

#include <istream>
#include <ostream>

#include "g2o/types/slam3d/g2o_types_slam3d_api.h"
#include "g2o/types/slam3d/se3_ops.h"

namespace g2o {

/// A rigid motion of space: a translation and a unit quaternion with w ≥ 0.
class G2O_TYPES_SLAM3D_API SE3Quat {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW

  SE3Quat() : _r(Quaternion::Identity()), _t(0, 0, 0) {}
  SE3Quat(const Matrix3& R, const Vector3& t) : _r(R), _t(t) { normalizeRotation(); }
  SE3Quat(const Quaternion& q, const Vector3& t) : _r(q), _t(t) { normalizeRotation(); }
  /// Converts a vector x y z qx qy qz qw or x y z qx qy qz.
  template <typename Derived>
  explicit SE3Quat(const Eigen::MatrixBase<Derived>& v) {
    const VectorX copy = v;
    if (copy.size() == 6) {
      fromMinimalVector(copy);
    } else {
      fromVector(copy);
    }
  }

  const Vector3& translation() const { return _t; }
  void setTranslation(const Vector3& t_) { _t = t_; }
  const Quaternion& rotation() const { return _r; }
  void setRotation(const Quaternion& r_) {
    _r = r_;
    normalizeRotation();
  }

  SE3Quat operator*(const SE3Quat& tr2) const { return SE3Quat(_r * tr2._r, _t + _r * tr2._t); }
  SE3Quat& operator*=(const SE3Quat& tr2) { return *this = *this * tr2; }
  Vector3 operator*(const Vector3& v) const { return _t + _r * v; }
  Vector3 map(const Vector3& xyz) const { return _t + _r * xyz; }
  SE3Quat inverse() const {
    const Quaternion r = _r.conjugate();
    return SE3Quat(r, r * Vector3(-_t));
  }

  /// Returns element i of x y z qx qy qz qw.
  double operator[](int i) const { return i < 3 ? _t[i] : _r.coeffs()[i - 3]; }
  Vector7 toVector() const {
    Vector7 v;
    v << _t, _r.coeffs();
    return v;
  }
  void fromVector(const Vector7& v) {
    _r.coeffs() = v.tail<4>();
    _t = v.head<3>();
    normalizeRotation();
  }
  /// x y z qx qy qz.
  Vector6 toMinimalVector() const { return toVector().head<6>(); }
  void fromMinimalVector(const Vector6& v);

  /// log() converts to (ω, υ), and exp() converts back: exp(ω, υ) = (R, V υ) with the left Jacobian V of the
  /// rotation.
  Vector6 log() const;
  static SE3Quat exp(const Vector6& update);

  /// The adjoint Ad with exp(Ad δ) = T exp(δ) T⁻¹.
  Matrix6 adj() const {
    const Matrix3 R = _r.toRotationMatrix();
    Matrix6 result;
    result << R, Matrix3::Zero(), skew(_t) * R, R;
    return result;
  }

  Matrix4 to_homogeneous_matrix() const {
    Matrix4 m = Matrix4::Identity();
    m.topLeftCorner<3, 3>() = _r.toRotationMatrix();
    m.topRightCorner<3, 1>() = _t;
    return m;
  }
  operator Isometry3() const {  // NOLINT: clients rely on the implicit conversion
    Isometry3 result = Isometry3::Identity();
    result.linear() = _r.toRotationMatrix();
    result.translation() = _t;
    return result;
  }

  void normalizeRotation() {
    if (_r.w() < 0) _r.coeffs() *= -1;
    _r.normalize();
  }

 protected:
  Quaternion _r;
  Vector3 _t;
};

inline std::ostream& operator<<(std::ostream& os, const SE3Quat& se3) {
  return os << se3.to_homogeneous_matrix() << '\n';
}

namespace internal {

template <class E>
struct KeptMeasurement;

/// A measured motion and its inverse (see ReadyMadeEdge).
template <>
struct KeptMeasurement<SE3Quat> {
  SE3Quat _inverseMeasurement;
  void keep(const SE3Quat& m) { _inverseMeasurement = m.inverse(); }
};

}  // namespace internal
}  // namespace g2o

#endif  // G2O_SE3QUAT_H_
