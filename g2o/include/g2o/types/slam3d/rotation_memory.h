// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_ROTATION_MEMORY_H
#define G2O_ROTATION_MEMORY_H

#include <array>

#include "g2o/core/eigen_types.h"
#include "g2o/types/slam3d/g2o_types_slam3d_api.h"

namespace g2o {
namespace internal {

/// Remembers the quaternion of a rotation matrix until the matrix changes. The remembered quaternion is not
/// normalized, so that a pose that was read from a file is written with the same digits.
class G2O_TYPES_SLAM3D_API RotationMemory {
 public:
  using Coefficients = std::array<double, 4>;  ///< x y z w
  /// Sets R to the rotation of q and remembers q.
  void set(const Coefficients& q, Eigen::Ref<Matrix3, 0, Eigen::OuterStride<>> R);
  /// Remembers the quaternion of a pose, so that get() does not have to compute it.
  void keep(const Isometry3& pose);
  Coefficients get(const Isometry3& pose) const;

 private:
  Eigen::Matrix<double, 3, 3, Eigen::DontAlign> rotation_ =
      Eigen::Matrix<double, 3, 3, Eigen::DontAlign>::Zero();
  Coefficients quaternion_{{0, 0, 0, 1}};
};

template <class E>
struct KeptMeasurement;

/// A measured motion, its inverse and its quaternion (see ReadyMadeEdge).
template <>
struct KeptMeasurement<Isometry3> {
  Isometry3 _inverseMeasurement = Isometry3::Identity();
  RotationMemory rotation_;
  void keep(const Isometry3& m) {
    _inverseMeasurement = m.inverse();
    rotation_.keep(m);
  }
};

}  // namespace internal
}  // namespace g2o

#endif  // G2O_ROTATION_MEMORY_H
