// SPDX-License-Identifier: BSD-3-Clause
// The frames of the manifold types: SE2 and SE3 are poses, vectors of two or three scalars are points, and a
// product has the frame of its first part.
//
// The vertex pools include this file, so that every translation unit sees the same specializations.
#pragma once

#include <algorithm>
#include <cmath>

#include "boxplus/graph/frame.h"
#include "boxplus/manifold/product.h"
#include "boxplus/manifold/rn.h"
#include "boxplus/manifold/se2.h"
#include "boxplus/manifold/se3.h"

namespace boxplus::detail {

template <>
struct FrameTrait<SE2> {
  static Frame get(const SE2& x) {
    const Matrix<double, 2, 2> r = x.rotation();
    return {2, true, {r(0, 0), r(0, 1), r(1, 0), r(1, 1)}, {x.x(), x.y()}};
  }
  static void set(SE2& x, const Frame& frame) {
    x = SE2(frame.translation[0], frame.translation[1], std::atan2(frame.rotation[2], frame.rotation[0]));
  }
};

template <class Chart>
struct FrameTrait<BasicSE3<double, Chart>> {
  using Pose = BasicSE3<double, Chart>;
  static Frame get(const Pose& x) {
    Frame frame{3, true, {}, {x.data()[0], x.data()[1], x.data()[2]}};
    const Matrix<double, 3, 3> r = x.rotation();
    for (int i = 0; i < 9; ++i) frame.rotation[static_cast<std::size_t>(i)] = r(i / 3, i % 3);
    return frame;
  }
  static void set(Pose& x, const Frame& frame) {
    const Matrix<double, 3, 3> r =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(frame.rotation.data());
    // A new frame keeps the norm of the quaternion, as ⊞ does (see Manifold<BasicSE3>).
    const double n2 = x.quaternion().squared_norm();
    const double norm = n2 > 0.5 && n2 < 2 ? std::sqrt(n2) : 1;  // 1 also if the old estimate is not finite
    x = Pose::from_unit(Vector3(frame.translation.data()), scaled(normalized(quaternion_of(r)), norm));
  }
};

/// Points in the plane and in space.
template <int N, int Options, int MaxRows, int MaxCols>
requires(N == 2 || N == 3) struct FrameTrait<Eigen::Matrix<double, N, 1, Options, MaxRows, MaxCols>> {
  using Point = Eigen::Matrix<double, N, 1, Options, MaxRows, MaxCols>;
  static Frame get(const Point& x) {
    Frame frame{N, false, {}, {}};
    std::copy_n(x.data(), N, frame.translation.begin());
    return frame;
  }
  static void set(Point& x, const Frame& frame) { std::copy_n(frame.translation.begin(), N, x.data()); }
};

/// A pose or point with more parts: a camera with its intrinsics, a robot with its velocity.
template <FrameType First, class... Rest>
struct FrameTrait<Product<First, Rest...>> {
  static Frame get(const Product<First, Rest...>& x) { return FrameTrait<First>::get(x.template get<0>()); }
  static void set(Product<First, Rest...>& x, const Frame& frame) {
    FrameTrait<First>::set(x.template get<0>(), frame);
  }
};

}  // namespace boxplus::detail
