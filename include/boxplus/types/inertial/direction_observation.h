// SPDX-License-Identifier: BSD-3-Clause
// Directions and fields of the world, measured by a body: the vertical by an accelerometer at rest, the
// magnetic field by a magnetometer, the sun by a sun sensor.
#pragma once

#include "boxplus/manifold/s2.h"
#include "boxplus/types/pose_math.h"

namespace boxplus {

namespace detail {
/// Rᵀ v for the rotation R of a pose or a rotation.
template <class X, class V>
auto rotate_back(const X& x, const V& v) {
  return rotate(x.quaternion().conjugate(), v[0], v[1], v[2]);
}
}  // namespace detail

/// z measures the direction d of the world in the frame of the body. Error: (Rᵀ d) ⊟ z, two angles in
/// radians. So the error does not depend on how strong the measured vector was. Vertices:
///   X, d      the pose or rotation of the body (T_world_body: SE3 or SO3, with any chart), the direction
///   (S2) X, d, M   the sensor is turned by M (T_body_sensor, of the same type as X), and z is in its frame
/// If the direction is known, add it by Graph::add_parameter(). One direction does not determine a rotation:
/// the body may turn around it.
struct DirectionObservation {
  static constexpr std::string_view kName = "DirectionObservation";
  S2 measurement;

  explicit DirectionObservation(const S2& z) : measurement(z) {}

  template <class X, class S>
  Vector<S, 2> error(const X& x, const BasicS2<S>& direction) const {
    return difference(detail::rotate_back(x, direction.vector()));
  }
  template <class X, class S>
  Vector<S, 2> error(const X& x, const BasicS2<S>& direction, const X& mount) const {
    return difference(detail::rotate_back(mount, detail::rotate_back(x, direction.vector())));
  }

 private:
  template <class S>
  Vector<S, 2> difference(const Vector<S, 3>& seen) const {
    return detail::difference(BasicS2<S>::from_unit(seen[0], seen[1], seen[2]), measurement);
  }
};

/// z measures the vector m of the world in the frame of the body, plus a constant bias b. Error: Rᵀ m + b −
/// z, in the unit of m. For a magnetometer, m is the magnetic field of the earth, and b the field of the body
/// (its hard iron). Vertices: X (SE3 or SO3, with any chart), m (Vector3), b (Vector3).
struct FieldObservation {
  static constexpr std::string_view kName = "FieldObservation";
  Vector3 measurement;

  explicit FieldObservation(const Vector3& z) : measurement(z) {}

  template <class X, class S>
  Vector<S, 3> error(const X& x, const Vector<S, 3>& field, const Vector<S, 3>& bias) const {
    return detail::rotate_back(x, field) + bias - measurement;
  }
};

}  // namespace boxplus
