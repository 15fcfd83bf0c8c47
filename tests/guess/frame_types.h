// SPDX-License-Identifier: BSD-3-Clause
// Small vertex and edge types with frames, for tests of initial guesses in the plane and in space.
#pragma once

#include "boxplus/graph/graph.h"
#include "boxplus/manifold/rn.h"
#include "boxplus/manifold/se2.h"
#include "boxplus/manifold/se3.h"

namespace boxplus::test {

/// Plane and Space are the two possible parameters `World` of the types in this file. Each of them defines
/// the type of a motion and the dimensions of positions and poses.
struct Plane {
  using Motion = SE2;
  static constexpr int kDim = 2, kPoseDim = 3;
  static constexpr double kRotationUnit = 1;
  static SE2 motion(double seed) { return {1 + std::sin(seed), std::cos(2 * seed), 1.1 * seed}; }
  static SE2 from(const detail::Frame& f) {
    return {f.translation[0], f.translation[1], std::atan2(f.rotation[2], f.rotation[0])};
  }
};
struct Space {
  using Motion = SE3;
  static constexpr int kDim = 3, kPoseDim = 6;
  static constexpr double kRotationUnit = 0.5;
  static SE3 motion(double seed) {
    const Vector<double, 3> omega(std::sin(3 * seed), 1.1 * seed, std::cos(seed));
    return {Vector<double, 3>(1 + std::sin(seed), std::cos(2 * seed), std::sin(5 * seed)),
            SO3::from_rotation_vector(omega)};
  }
  static SE3 from(const detail::Frame& f) {
    const Matrix<double, 3, 3> r =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(f.rotation.data());
    return {Vector<double, 3>(f.translation[0], f.translation[1], f.translation[2]), r};
  }
};

template <class World>
struct Pose {
  typename World::Motion motion;
};
template <class World>
struct Point {
  Vector<double, World::kDim> position;
};

template <class World>
detail::Frame frame_of(const typename World::Motion& motion) {
  detail::Frame frame;
  frame.dimension = World::kDim;
  frame.has_rotation = true;
  const auto r = motion.rotation();
  for (int i = 0; i < r.size(); ++i)
    frame.rotation[static_cast<std::size_t>(i)] = r(i / World::kDim, i % World::kDim);
  for (int i = 0; i < World::kDim; ++i)
    frame.translation[static_cast<std::size_t>(i)] = motion.translation()[i];
  return frame;
}
template <class World>
detail::Frame frame_of(const Vector<double, World::kDim>& position) {
  detail::Frame frame;
  frame.dimension = World::kDim;
  for (int i = 0; i < World::kDim; ++i) frame.translation[static_cast<std::size_t>(i)] = position[i];
  return frame;
}

template <class World>
detail::RelativeFrame relative(int from, int to, const detail::Frame& motion) {
  detail::RelativeFrame result{from, to, motion};
  result.translation_rows = World::kDim;
  if (motion.has_rotation) {
    result.rotation_row = World::kDim;
    result.rotation_rows = World::kPoseDim - World::kDim;
    result.rotation_unit = World::kRotationUnit;
  }
  return result;
}

template <class World>
using PoseError = Vector<double, World::kPoseDim>;
template <class World>
using PointError = Vector<double, World::kDim>;

template <class World>
PoseError<World> difference(const typename World::Motion& y, const typename World::Motion& x) {
  PoseError<World> e;
  Manifold<typename World::Motion>::ominus(y, x, e.data());
  return e;
}

/// Measures a pose relative to another pose.
template <class World>
struct Between {
  typename World::Motion z;
  PoseError<World> error(const Pose<World>& a, const Pose<World>& b) const {
    return difference<World>(a.motion.inverse() * b.motion, z);
  }
  detail::RelativeFrame relative_frame(const Pose<World>&, const Pose<World>&) const {
    return relative<World>(0, 1, frame_of<World>(z));
  }
};

/// Measures a sensor relative to another sensor. The two sensors have the same mount on their poses.
template <class World>
struct MountedBetween {
  typename World::Motion z;
  PoseError<World> error(const Pose<World>& a, const Pose<World>& b, const Pose<World>& mount) const {
    return difference<World>((a.motion * mount.motion).inverse() * (b.motion * mount.motion), z);
  }
  detail::RelativeFrame relative_frame(const Pose<World>&, const Pose<World>&,
                                       const Pose<World>& mount) const {
    return relative<World>(0, 1, frame_of<World>(mount.motion * z * mount.motion.inverse()));
  }
};

/// Measures a point relative to a pose.
template <class World>
struct Sighting {
  PointError<World> z;
  PointError<World> error(const Pose<World>& a, const Point<World>& b) const {
    return a.motion.inverse() * b.position - z;
  }
  detail::RelativeFrame relative_frame(const Pose<World>&, const Point<World>&) const {
    return relative<World>(0, 1, frame_of<World>(z));
  }
};

/// Measures only the direction of a point relative to a pose, so the edge has no relative frame.
template <class World>
struct Direction {
  PointError<World> z;
  PointError<World> error(const Pose<World>& a, const Point<World>& b) const {
    return (a.motion.inverse() * b.position).normalized() - z;
  }
};

/// Measures a point relative to another point, along the axes of the world.
template <class World>
struct Offset {
  PointError<World> z;
  PointError<World> error(const Point<World>& a, const Point<World>& b) const {
    return b.position - a.position - z;
  }
  detail::RelativeFrame relative_frame(const Point<World>&, const Point<World>&) const {
    return relative<World>(0, 1, frame_of<World>(z));
  }
};

/// Measures a pose in the world frame.
template <class World>
struct Prior {
  typename World::Motion z;
  PoseError<World> error(const Pose<World>& a) const { return difference<World>(a.motion, z); }
  detail::RelativeFrame relative_frame(const Pose<World>&) const {
    return relative<World>(detail::RelativeFrame::kWorld, 0, frame_of<World>(z));
  }
};
/// Measures the position of a pose in the world frame.
template <class World>
struct PositionPrior {
  PointError<World> z;
  PointError<World> error(const Pose<World>& a) const { return a.motion.translation() - z; }
  detail::RelativeFrame relative_frame(const Pose<World>&) const {
    return relative<World>(detail::RelativeFrame::kWorld, 0, frame_of<World>(z));
  }
};
/// Measures a point in the world frame.
template <class World>
struct PointPrior {
  PointError<World> z;
  PointError<World> error(const Point<World>& a) const { return a.position - z; }
  detail::RelativeFrame relative_frame(const Point<World>&) const {
    return relative<World>(detail::RelativeFrame::kWorld, 0, frame_of<World>(z));
  }
};

}  // namespace boxplus::test

namespace boxplus {

template <class World>
struct Manifold<test::Pose<World>> {
  static constexpr int kDim = World::kPoseDim;
  static test::Pose<World> oplus(const test::Pose<World>& x, const double* delta) {
    return {Manifold<typename World::Motion>::oplus(x.motion, delta)};
  }
  static void ominus(const test::Pose<World>& y, const test::Pose<World>& x, double* delta) {
    Manifold<typename World::Motion>::ominus(y.motion, x.motion, delta);
  }
};
template <class World>
struct Manifold<test::Point<World>> {
  static constexpr int kDim = World::kDim;
  static test::Point<World> oplus(const test::Point<World>& x, const double* delta) {
    return {x.position + Eigen::Map<const Vector<double, World::kDim>>(delta)};
  }
  static void ominus(const test::Point<World>& y, const test::Point<World>& x, double* delta) {
    for (int i = 0; i < kDim; ++i) delta[i] = y.position[i] - x.position[i];
  }
};
template <class World>
struct detail::FrameTrait<test::Pose<World>> {
  static detail::Frame get(const test::Pose<World>& x) { return test::frame_of<World>(x.motion); }
  static void set(test::Pose<World>& x, const detail::Frame& frame) { x.motion = World::from(frame); }
};
template <class World>
struct detail::FrameTrait<test::Point<World>> {
  static detail::Frame get(const test::Point<World>& x) { return test::frame_of<World>(x.position); }
  static void set(test::Point<World>& x, const detail::Frame& frame) {
    for (int i = 0; i < World::kDim; ++i) x.position[i] = frame.translation[static_cast<std::size_t>(i)];
  }
};

}  // namespace boxplus
