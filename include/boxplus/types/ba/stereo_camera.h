// SPDX-License-Identifier: BSD-3-Clause
// Rectified stereo cameras without distortion: two equal pinhole cameras with parallel axes. The second
// camera is displaced along the x axis of the first by the baseline (meters). The first camera alone is an
// ordinary camera. The vertices here are those of g2o's types sba.
#pragma once

#include <string_view>
#include <utility>

#include "boxplus/graph/manifold_frames.h"
#include "boxplus/types/ba/camera_models.h"

namespace boxplus::detail {

/// The images of a point p in the frame of the first camera, for a pair with bf = baseline · fx:
///   Rows = 2: (u, v)               (u, v) is the pixel in the first camera
///   Rows = 3: (u, v, u − bf/p_z)   the last value is the column in the second camera
template <class S>
struct StereoPinhole {
  BasicCamera<PinholeModel, S> first;  ///< fx, fy, cx, cy
  S bf;

  template <int Rows>
  Vector<S, Rows> image(const Vector<S, 3>& p) const {
    static_assert(Rows == 2 || Rows == 3);
    Vector<S, 2> pixel = first.project(p);
    if constexpr (Rows == 2) {
      return pixel;
    } else {
      return {pixel[0], pixel[1], pixel[0] - bf * inverse(p[2]).value};
    }
  }
};

/// The derivatives of image<Rows>(): by p, and by fx, fy, cx, cy, bf.
template <int Rows>
struct ImageDerivatives {
  Matrix<double, Rows, 3> by_point;
  Matrix<double, Rows, 5> by_parameters;

  ImageDerivatives(const StereoPinhole<double>& camera, const Vector3& p) {
    Matrix<double, 2, 3> J_point;
    Matrix<double, 2, 4> J_first;
    camera.first.project(p, J_point, J_first);
    by_point.template topRows<2>() = J_point;
    by_parameters.setZero();
    by_parameters.template topLeftCorner<2, 4>() = J_first;
    if constexpr (Rows == 3) {
      const Inverse<double> depth = inverse(p[2]);
      by_point.row(2) = by_point.row(0);
      by_point(2, 2) -= camera.bf * depth.slope;
      by_parameters.row(2) = by_parameters.row(0);
      by_parameters(2, 4) = -depth.value;
    }
  }
};

/// The manifold of a Point<S> with four `parameters`, to which ⊞ adds. All other members are constants.
template <template <class> class Point, class S>
struct FourParameters {
  template <class T>
  using Rebind = Point<T>;
  static constexpr int kDim = 4;

  template <class D>
  static Rebind<Promoted<S, D>> oplus(const Point<S>& x, const D* delta) {
    Rebind<Promoted<S, D>> y = Manifold<Point<S>>::template cast<Promoted<S, D>>(x);
    for (int i = 0; i < kDim; ++i) y.parameters[i] = x.parameters[i] + delta[i];
    return y;
  }
  template <class D>
  static void ominus(const Point<S>& y, const Point<S>& x, D* delta) {
    for (int i = 0; i < kDim; ++i) delta[i] = y.parameters[i] - x.parameters[i];
  }
};

}  // namespace boxplus::detail

namespace boxplus {

/// f, cx, cy (pixels) and the baseline (meters). ⊞ adds. The tag in g2o files is PARAMS_CAMERAPARAMETERS.
template <class S>
struct BasicStereoCamera {
  using Scalar = S;
  static constexpr std::string_view kName = "StereoCamera";
  Vector<S, 4> parameters = Vector<S, 4>(S(1), S(0), S(0), S(0));

  detail::StereoPinhole<S> pinhole() const {
    const S& f = parameters[0];
    return {BasicCamera<detail::PinholeModel, S>(f, f, parameters[1], parameters[2]), f * parameters[3]};
  }
};

using StereoCamera = BasicStereoCamera<double>;

template <class S>
struct Manifold<BasicStereoCamera<S>> : detail::FourParameters<BasicStereoCamera, S> {
  template <class T>
  static BasicStereoCamera<T> cast(const BasicStereoCamera<S>& x) {
    return {x.parameters.template cast<T>()};
  }
};

/// fx, fy, cx, cy (pixels) and the baseline (meters), which is known: ⊞ adds to the first four values. The
/// tag in g2o files is VERTEX_INTRINSICS.
template <class S>
struct BasicStereoIntrinsics {
  using Scalar = S;
  static constexpr std::string_view kName = "StereoIntrinsics";
  Vector<S, 4> parameters = Vector<S, 4>(S(1), S(1), S(0.5), S(0.5));
  double baseline = 0.1;

  detail::StereoPinhole<S> pinhole() const {
    return {BasicCamera<detail::PinholeModel, S>(parameters), parameters[0] * baseline};
  }
};

using StereoIntrinsics = BasicStereoIntrinsics<double>;

template <class S>
struct Manifold<BasicStereoIntrinsics<S>> : detail::FourParameters<BasicStereoIntrinsics, S> {
  template <class T>
  static BasicStereoIntrinsics<T> cast(const BasicStereoIntrinsics<S>& x) {
    return {x.parameters.template cast<T>(), x.baseline};
  }
};

/// The pose of a stereo camera (T_world_camera) with known intrinsics. ⊞ is that of SE3, and changes only the
/// pose. The tag in g2o files is VERTEX_CAM.
template <class S>
struct BasicStereoPose {
  using Scalar = S;
  static constexpr std::string_view kName = "StereoPose";
  BasicSE3<S> pose;
  StereoIntrinsics intrinsics = {Vector<double, 4>(300, 300, 320, 320), 0.1};

  Vector<S, 3> translation() const { return pose.translation(); }
  detail::StereoPinhole<S> pinhole() const {
    return Manifold<StereoIntrinsics>::cast<S>(intrinsics).pinhole();
  }
};

using StereoPose = BasicStereoPose<double>;

template <class S>
struct Manifold<BasicStereoPose<S>> {
  using Point = BasicStereoPose<S>;
  template <class T>
  using Rebind = BasicStereoPose<T>;
  static constexpr int kDim = 6;

  template <class D>
  static Rebind<detail::Promoted<S, D>> oplus(const Point& x, const D* delta) {
    return {Manifold<BasicSE3<S>>::oplus(x.pose, delta), x.intrinsics};
  }
  template <class D>
  static void ominus(const Point& y, const Point& x, D* delta) {
    Manifold<BasicSE3<S>>::ominus(y.pose, x.pose, delta);
  }
  template <class T>
  static Rebind<T> cast(const Point& x) {
    return {x.pose.template cast<T>(), x.intrinsics};
  }
};

template <>
struct detail::FrameTrait<StereoPose> {
  static Frame get(const StereoPose& x) { return FrameTrait<SE3>::get(x.pose); }
  static void set(StereoPose& x, const Frame& frame) { FrameTrait<SE3>::set(x.pose, frame); }
};

}  // namespace boxplus
