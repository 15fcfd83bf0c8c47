// SPDX-License-Identifier: BSD-3-Clause
// Converts rotations, rigid motions and similarities between the types of boxplus, the types of Eigen, and
// types with the interface of Sophus.
//
//     SE3 x = convert_to<SE3>(isometry);  // an Eigen::Isometry3d
//     auto isometry = convert_to<Eigen::Isometry3d>(x);
//     auto y = convert_to<Sophus::SE3d>(x);
//
//   boxplus                  Eigen                       any type T with these members
//   SO2                      Rotation2D                  unit_complex(), T(angle)
//   SE2                      Isometry2                   unit_complex(), translation(), T(angle, translation)
//   SO3, SO3RotationVector   Quaternion, AngleAxis       unit_quaternion(), T(unit quaternion)
//   SE3, SE3RotationVector   Isometry3                   unit_quaternion(), translation(),
//                                                        T(unit quaternion, translation)
//   Sim3                     Affine3, of the form s R    quaternion(), scale(), translation(),
//                                                        T(√scale · unit quaternion, translation)
//
// Each type converts to the other types in its row. It also converts to the types in lower rows, if these are
// in the same space (the plane or 3D space): a rotation becomes a motion without translation, and a motion
// becomes a similarity of scale 1. A conversion that would lose a translation or a scale does not compile.
// The scalar type of Eigen's types and of T may be float. A matrix or quaternion must be a rotation up to
// rounding errors; the conversion normalizes it.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <type_traits>

#include "boxplus/manifold/se2.h"
#include "boxplus/manifold/se3.h"
#include "boxplus/manifold/sim3.h"
#include "boxplus/manifold/so2.h"
#include "boxplus/manifold/so3.h"

namespace boxplus {

namespace conversion {

struct PlaneMotion {
  double angle = 0;
  Vector2 translation = Vector2::Zero();
};
struct SpaceMotion {
  detail::Quaternion<double> rotation = detail::Quaternion<double>::identity();
  Vector3 translation = Vector3::Zero();
  double scale = 1;
};

/// The parts of a motion: rotation only; rotation and translation; rotation, translation and scale.
enum class Parts { kRotation, kRigid, kSimilar };

/// Form<T> converts T to and from the common form M, which is PlaneMotion or SpaceMotion.
template <class M, Parts kHas>
struct FormOf {
  using Motion = M;
  static constexpr Parts kParts = kHas;
};
template <class T>
struct Form;

template <>
struct Form<SO2> : FormOf<PlaneMotion, Parts::kRotation> {
  static PlaneMotion read(const SO2& x) { return {.angle = x.angle()}; }
  static SO2 write(const PlaneMotion& m) { return SO2(m.angle); }
};
template <>
struct Form<SE2> : FormOf<PlaneMotion, Parts::kRigid> {
  static PlaneMotion read(const SE2& x) { return {x.theta(), x.translation()}; }
  static SE2 write(const PlaneMotion& m) { return {m.translation, m.angle}; }
};
template <class Chart>
struct Form<BasicSO3<double, Chart>> : FormOf<SpaceMotion, Parts::kRotation> {
  static SpaceMotion read(const BasicSO3<double, Chart>& x) { return {.rotation = x.quaternion()}; }
  static BasicSO3<double, Chart> write(const SpaceMotion& m) {
    return BasicSO3<double, Chart>::from_unit(m.rotation);
  }
};
template <class Chart>
struct Form<BasicSE3<double, Chart>> : FormOf<SpaceMotion, Parts::kRigid> {
  static SpaceMotion read(const BasicSE3<double, Chart>& x) { return {x.quaternion(), x.translation()}; }
  static BasicSE3<double, Chart> write(const SpaceMotion& m) {
    return BasicSE3<double, Chart>::from_unit(m.translation, m.rotation);
  }
};
template <>
struct Form<Sim3> : FormOf<SpaceMotion, Parts::kSimilar> {
  static SpaceMotion read(const Sim3& x) { return {x.quaternion(), x.translation(), x.scale()}; }
  static Sim3 write(const SpaceMotion& m) { return Sim3::from_unit(m.rotation, m.translation, m.scale); }
};

template <class Q>
detail::Quaternion<double> unit_quaternion_from(const Q& q) {
  return detail::normalized(
      detail::Quaternion<double>{double(q.x()), double(q.y()), double(q.z()), double(q.w())});
}
template <class S>
Eigen::Quaternion<S> eigen_quaternion(const SpaceMotion& m) {
  const detail::Quaternion<double> q = detail::normalized(m.rotation);
  return {S(q.w), S(q.x), S(q.y), S(q.z)};
}

template <class S>
struct Form<Eigen::Rotation2D<S>> : FormOf<PlaneMotion, Parts::kRotation> {
  static PlaneMotion read(const Eigen::Rotation2D<S>& x) {
    return {.angle = detail::normalize_angle(double(x.angle()))};
  }
  static Eigen::Rotation2D<S> write(const PlaneMotion& m) { return Eigen::Rotation2D<S>(S(m.angle)); }
};
template <class S, int Options>
struct Form<Eigen::Transform<S, 2, Eigen::Isometry, Options>> : FormOf<PlaneMotion, Parts::kRigid> {
  using T = Eigen::Transform<S, 2, Eigen::Isometry, Options>;
  static PlaneMotion read(const T& x) {
    return {std::atan2(double(x.linear()(1, 0)), double(x.linear()(0, 0))),
            x.translation().template cast<double>()};
  }
  static T write(const PlaneMotion& m) {
    T x = T::Identity();
    x.linear() = SO2(m.angle).rotation().template cast<S>();
    x.translation() = m.translation.template cast<S>();
    return x;
  }
};
template <class S, int Options>
struct Form<Eigen::Quaternion<S, Options>> : FormOf<SpaceMotion, Parts::kRotation> {
  static SpaceMotion read(const Eigen::Quaternion<S, Options>& x) {
    return {.rotation = unit_quaternion_from(x)};
  }
  static Eigen::Quaternion<S, Options> write(const SpaceMotion& m) {
    return Eigen::Quaternion<S, Options>(eigen_quaternion<S>(m));
  }
};
template <class S>
struct Form<Eigen::AngleAxis<S>> : FormOf<SpaceMotion, Parts::kRotation> {
  static SpaceMotion read(const Eigen::AngleAxis<S>& x) {
    return {.rotation = unit_quaternion_from(Eigen::Quaternion<S>(x))};
  }
  static Eigen::AngleAxis<S> write(const SpaceMotion& m) {
    return Eigen::AngleAxis<S>(eigen_quaternion<S>(m));
  }
};
/// The similarity x ↦ linear · x + translation. Its scale is the cube root of the determinant.
template <class S, int Mode, int Options>
requires(Mode != Eigen::Projective) struct Form<Eigen::Transform<S, 3, Mode, Options>>
    : FormOf<SpaceMotion, Mode == Eigen::Isometry ? Parts::kRigid : Parts::kSimilar> {
  using T = Eigen::Transform<S, 3, Mode, Options>;
  static SpaceMotion read(const T& x) {
    const Matrix<double, 3, 3> linear = x.linear().template cast<double>();
    const double scale = Mode == Eigen::Isometry ? 1 : std::cbrt(linear.determinant());
    return {detail::normalized(detail::quaternion_of((linear / scale).eval())),
            x.translation().template cast<double>(), scale};
  }
  static T write(const SpaceMotion& m) {
    T x = T::Identity();
    x.linear() = (m.scale * rotation_matrix(detail::normalized(m.rotation))).template cast<S>();
    x.translation() = m.translation.template cast<S>();
    return x;
  }
};

template <class T>
concept HasTranslation = requires(const T& x) {
  x.translation()[0];
};
template <class T>
concept HasUnitComplex = requires(const T& x) {
  x.unit_complex()[1];
};
template <class T>
concept HasUnitQuaternion = requires(const T& x) {
  x.unit_quaternion().w();
};
template <class T>
concept HasScaledQuaternion = requires(const T& x) {
  x.quaternion().w();
  x.scale();
};

template <HasUnitComplex T>
struct Form<T> : FormOf<PlaneMotion, HasTranslation<T> ? Parts::kRigid : Parts::kRotation> {
  using S = typename T::Scalar;
  static PlaneMotion read(const T& x) {
    const auto c = x.unit_complex();
    PlaneMotion m{.angle = std::atan2(double(c[1]), double(c[0]))};
    if constexpr (HasTranslation<T>) m.translation = x.translation().template cast<double>();
    return m;
  }
  static T write(const PlaneMotion& m) {
    if constexpr (HasTranslation<T>) {
      return T(S(m.angle), Eigen::Matrix<S, 2, 1>(m.translation.template cast<S>()));
    } else {
      return T(S(m.angle));
    }
  }
};
template <HasUnitQuaternion T>
struct Form<T> : FormOf<SpaceMotion, HasTranslation<T> ? Parts::kRigid : Parts::kRotation> {
  using S = typename T::Scalar;
  static SpaceMotion read(const T& x) {
    SpaceMotion m{.rotation = unit_quaternion_from(x.unit_quaternion())};
    if constexpr (HasTranslation<T>) m.translation = x.translation().template cast<double>();
    return m;
  }
  static T write(const SpaceMotion& m) {
    if constexpr (HasTranslation<T>) {
      return T(eigen_quaternion<S>(m), Eigen::Matrix<S, 3, 1>(m.translation.template cast<S>()));
    } else {
      return T(eigen_quaternion<S>(m));
    }
  }
};
template <HasScaledQuaternion T>
requires HasTranslation<T>
struct Form<T> : FormOf<SpaceMotion, Parts::kSimilar> {
  using S = typename T::Scalar;
  static SpaceMotion read(const T& x) {
    return {unit_quaternion_from(x.quaternion()), x.translation().template cast<double>(), double(x.scale())};
  }
  static T write(const SpaceMotion& m) {
    Eigen::Quaternion<S> q = eigen_quaternion<S>(m);
    q.coeffs() *= S(std::sqrt(m.scale));
    return T(q, Eigen::Matrix<S, 3, 1>(m.translation.template cast<S>()));
  }
};

/// Both types are motions of the same space, and the type To has every part that the type From has.
template <class From, class To>
concept Fits = std::is_same_v < typename Form<From>::Motion,
typename Form<To>::Motion > &&(Form<From>::kParts <= Form<To>::kParts);

}  // namespace conversion

/// Converts `x` to the type To, if the table above allows it. The result is exact up to rounding. Between
/// types of boxplus, the conversion copies all numbers unchanged.
template <class To, class From>
requires conversion::Fits<From, To> To convert_to(const From& x) {
  return conversion::Form<To>::write(conversion::Form<From>::read(x));
}

}  // namespace boxplus
