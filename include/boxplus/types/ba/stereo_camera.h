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

/// The derivatives of StereoPinhole::image<Rows>() at a point p. With s = 1/p_z and its slope s′ (inverse()),
/// the rows of D = ∂image/∂p are
///   u: (fx s, 0, fx p_x s′)
///   v: (0, fy s, fy p_y s′)
///   u in the second camera: (fx s, 0, fx p_x s′ − bf s′)
/// BasicCamera::project() has the same derivatives, by the formulas of all lenses. These are faster, because
/// they leave out the zeros.
template <int Rows>
class ImageDerivatives {
  static_assert(Rows == 2 || Rows == 3);

 public:
  ImageDerivatives(const StereoPinhole<double>& camera, const Vector3& p) : x_(p[0]), y_(p[1]), z_(p[2]) {
    const Inverse<double> depth = inverse(z_);
    const double fx = camera.first.parameters[0], fy = camera.first.parameters[1];
    inverse_ = depth.value;
    u_by_x_ = fx * depth.value;
    v_by_y_ = fy * depth.value;
    u_by_z_ = fx * (depth.slope * x_);
    v_by_z_ = fy * (depth.slope * y_);
    if constexpr (Rows == 3) second_by_z_ = u_by_z_ - camera.bf * depth.slope;
  }

  /// D.
  Matrix<double, Rows, 3> by_point() const {
    Matrix<double, Rows, 3> J;
    J.template topRows<2>() << u_by_x_, 0, u_by_z_, 0, v_by_y_, v_by_z_;
    if constexpr (Rows == 3) J.row(2) << u_by_x_, 0, second_by_z_;
    return J;
  }

  /// J ← D R: the derivatives by x, for p = R x + t.
  template <class A>
  void by_rotated_point(const Matrix<double, 3, 3>& R, A&& J) const {
    for (int j = 0; j < 3; ++j) {
      J(0, j) = u_by_x_ * R(0, j) + u_by_z_ * R(2, j);
      J(1, j) = v_by_y_ * R(1, j) + v_by_z_ * R(2, j);
      if constexpr (Rows == 3) J(2, j) = u_by_x_ * R(0, j) + second_by_z_ * R(2, j);
    }
  }

  /// J_t ← −D and J_omega ← D [p]×: the derivatives by the pose X of the camera, for p = X⁻¹ l, in the
  /// tangent (Δt, ω) of SE3RotationVector.
  template <class A, class B>
  [[gnu::always_inline]] void by_pose(A&& J_t, B&& J_omega) const {
    J_t(0, 0) = -u_by_x_;
    J_t(0, 1) = 0;
    J_t(0, 2) = -u_by_z_;
    J_t(1, 0) = 0;
    J_t(1, 1) = -v_by_y_;
    J_t(1, 2) = -v_by_z_;
    J_omega(0, 0) = -u_by_z_ * y_;
    J_omega(0, 1) = u_by_z_ * x_ - u_by_x_ * z_;
    J_omega(0, 2) = u_by_x_ * y_;
    J_omega(1, 0) = v_by_y_ * z_ - v_by_z_ * y_;
    J_omega(1, 1) = v_by_z_ * x_;
    J_omega(1, 2) = -v_by_y_ * x_;
    if constexpr (Rows == 3) {
      J_t(2, 0) = -u_by_x_;
      J_t(2, 1) = 0;
      J_t(2, 2) = -second_by_z_;
      J_omega(2, 0) = -second_by_z_ * y_;
      J_omega(2, 1) = second_by_z_ * x_ - u_by_x_ * z_;
      J_omega(2, 2) = u_by_x_ * y_;
    }
  }

  /// The derivatives by fx, fy, cx, cy, bf.
  Matrix<double, Rows, 5> by_parameters() const {
    const double u = x_ * inverse_, v = y_ * inverse_;
    Matrix<double, Rows, 5> J;
    J.template topRows<2>() << u, 0, 1, 0, 0, 0, v, 0, 1, 0;
    if constexpr (Rows == 3) J.row(2) << u, 0, 1, 0, -inverse_;
    return J;
  }

 private:
  double x_, y_, z_, inverse_;
  double u_by_x_, v_by_y_, u_by_z_, v_by_z_, second_by_z_;
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
