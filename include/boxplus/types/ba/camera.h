// SPDX-License-Identifier: BSD-3-Clause
// A camera: the intrinsic parameters of a camera model, which can be the estimate of a vertex.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "boxplus/base/matrix.h"
#include "boxplus/manifold/manifold.h"
#include "boxplus/manifold/scalar.h"
#include "boxplus/types/ba/lens.h"

namespace boxplus {

namespace detail {
/// BasicCamera::implausible(). The first parameters are the focal lengths. The coefficients k, k1, k2, … are
/// those of the 2nd, 4th, … power of the radius, and p1, p2 are as large as k1.
std::string implausible_intrinsics(const double* parameters, std::span<const std::string_view> names,
                                   int focal_lengths);
}  // namespace detail

/// A camera of the given model (types/ba/camera_models.h lists them). A point is given in the frame of the
/// camera, where x points right, y points down and z points forward; BAL's camera looks along −z, and its y
/// points up. The pixel is (fx u + cx, fy v + cy), where (u, v) is the image of the lens of the model.
///
/// A point that the camera does not see (sees()) has a pixel, too, which is finite for every finite point:
/// the formula of the model is continued. So pinhole models also project points behind the camera, as if they
/// were mirrored in its center. If the formula divides by a value of less than 1e-9, a smooth function
/// replaces the quotient. An estimate on the wrong side thus has a large error, and a gradient.
template <class CameraModel, class S = double>
struct BasicCamera {
  using Scalar = S;
  using Model = CameraModel;
  using Lens = typename Model::Lens;
  static constexpr std::string_view kName = Model::kName;
  /// The number of parameters.
  static constexpr int kSize = Model::kFocalLengths + (Model::kHasCenter ? 2 : 0) + Lens::kSize;
  static_assert(Model::kParameters.size() == kSize);

  /// In the order of Model::kParameters, which has their names.
  Vector<S, kSize> parameters;

  BasicCamera() { parameters.setZero(); }
  template <class Derived>
  explicit BasicCamera(const Eigen::MatrixBase<Derived>& values) : parameters(values) {}
  template <class... T>
  requires(sizeof...(T) == kSize) explicit BasicCamera(const T&... values) {
    int i = 0;
    ((parameters[i++] = S(values)), ...);
  }

  /// The pixel of a point.
  template <class Derived>
  Vector<detail::Promoted<S, typename Derived::Scalar>, 2> project(
      const Eigen::MatrixBase<Derived>& point) const {
    using R = detail::Promoted<S, typename Derived::Scalar>;
    const R p[3] = {R(point[0]), R(point[1]), R(point[2])};
    Vector<R, 2> pixel;
    if constexpr (std::is_same_v<R, S>) {
      project(p, parameters.data(), pixel.data(), nullptr, nullptr);
    } else {
      const Vector<R, kSize> k = parameters.template cast<R>();
      project(p, k.data(), pixel.data(), nullptr, nullptr);
    }
    return pixel;
  }

  /// The pixel, J_point ← ∂pixel/∂point (2 × 3), and J_parameters ← ∂pixel/∂parameters (2 × kSize).
  template <class A, class B>
  Vector<S, 2> project(const Vector<S, 3>& point, A&& J_point, B&& J_parameters) const {
    Vector<S, 2> pixel;
    Matrix<S, 2, 3> J_p;
    Matrix<S, 2, kSize> J_k;
    project(point.data(), parameters.data(), pixel.data(), J_p.data(), J_k.data());
    J_point = J_p;
    J_parameters = J_k;
    return pixel;
  }

  /// Whether the model describes the pixel of this point: the point is in front of the camera (a fisheye sees
  /// all directions but straight back), no denominator is zero or negative, and no root is that of a negative
  /// number.
  template <class Derived>
  bool sees(const Eigen::MatrixBase<Derived>& point) const {
    const S p[3] = {S(point[0]), S(point[1]), S(point[2])};
    return Lens::sees(p, parameters.data() + kLensBegin);
  }

  /// The same for plain arrays. T may be a pack of SIMD lanes (types/ba/distortion.h). J is T*, for
  /// column-major derivatives, or nullptr.
  template <class T, class J>
  static void project(const T* point, const T* k, T* pixel, J J_point, J J_parameters) {
    constexpr int kSecond = Model::kFocalLengths - 1;
    const T f[2] = {k[0], k[kSecond]};
    T image[2];
    if constexpr (detail::kWanted<J>) {
      T* const J_lens = J_parameters + 2 * kLensBegin;
      Lens::project(point, k + kLensBegin, image, J_point, J_lens);
      for (int i = 0; i < 6; ++i) J_point[i] = f[i % 2] * J_point[i];
      for (int i = 0; i < 2 * Lens::kSize; ++i) J_lens[i] = f[i % 2] * J_lens[i];
      if constexpr (kSecond == 1) J_parameters[1] = J_parameters[2] = T(0.0);
      J_parameters[0] = image[0];
      J_parameters[2 * kSecond + 1] = image[1];
      if constexpr (Model::kHasCenter) {
        T* const J_center = J_parameters + 2 * Model::kFocalLengths;
        J_center[0] = J_center[3] = T(1.0);
        J_center[1] = J_center[2] = T(0.0);
      }
    } else {
      Lens::project(point, k + kLensBegin, image, nullptr, nullptr);
    }
    for (int i = 0; i < 2; ++i) {
      pixel[i] = f[i] * image[i];
      if constexpr (Model::kHasCenter) pixel[i] = pixel[i] + k[Model::kFocalLengths + i];
    }
  }

  /// Says which parameter no camera has: "fx is -500, but focal lengths are positive". Otherwise, an empty
  /// text. This is a finding of diagnose().
  std::string implausible() const {
    return detail::implausible_intrinsics(parameters.data(), Model::kParameters, Model::kFocalLengths);
  }

 private:
  static constexpr int kLensBegin = kSize - Lens::kSize;
};

/// ⊞ adds to the parameters.
template <class Model, class S>
struct Manifold<BasicCamera<Model, S>> {
  template <class T>
  using Rebind = BasicCamera<Model, T>;
  static constexpr int kDim = BasicCamera<Model, S>::kSize;

  template <class D>
  static Rebind<detail::Promoted<S, D>> oplus(const BasicCamera<Model, S>& x, const D* delta) {
    Rebind<detail::Promoted<S, D>> y;
    for (int i = 0; i < kDim; ++i) y.parameters[i] = x.parameters[i] + delta[i];
    return y;
  }
  template <class D>
  static void ominus(const BasicCamera<Model, S>& y, const BasicCamera<Model, S>& x, D* delta) {
    for (int i = 0; i < kDim; ++i) delta[i] = y.parameters[i] - x.parameters[i];
  }
  template <class T>
  static Rebind<T> cast(const BasicCamera<Model, S>& x) {
    return Rebind<T>(x.parameters.template cast<T>());
  }
  static S* entry(BasicCamera<Model, S>& x, int i) { return &x.parameters[i]; }
};

}  // namespace boxplus
