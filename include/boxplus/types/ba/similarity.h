// SPDX-License-Identifier: BSD-3-Clause
// Cameras whose poses are similarities (Strasdat, Montiel and Davison, "Scale drift-aware large scale
// monocular SLAM", 2010), with the edges of g2o's type library sim3.
//
// With b = Y⁻¹ l for the similarity Y = (s, R, t) and the step δ = (ω, υ, σ) of Y ⊞ δ = Y exp(δ):
//   ∂b/∂δ = [ [b]×  −I  −b ]    ∂b/∂l = Rᵀ/s
//   ∂(Y p)/∂δ = s R [ −[p]×  I  p ]    ∂(Y p)/∂p = s R
#pragma once

#include <string_view>
#include <type_traits>

#include "boxplus/graph/manifold_frames.h"
#include "boxplus/manifold/sim3.h"
#include "boxplus/types/ba/camera_models.h"
#include "boxplus/types/pose_math.h"
#include "boxplus/types/slam3d/between_jacobians.h"

namespace boxplus {

/// A similarity that is always the exponential of a stored logarithm (ω, υ, σ), bit for bit. Files contain
/// the logarithm, so they can contain every value of this type exactly.
class LoggedSim3 {
 public:
  /// The identity.
  LoggedSim3() { logarithm_.setZero(); }
  explicit LoggedSim3(const Vector<double, 7>& logarithm)
      : value_(Sim3::exp(logarithm)), logarithm_(logarithm) {}
  /// x, up to rounding.
  explicit LoggedSim3(const Sim3& x) : LoggedSim3(x.log()) {}

  const Sim3& value() const { return value_; }
  const Vector<double, 7>& logarithm() const { return logarithm_; }

 private:
  Sim3 value_;
  Vector<double, 7> logarithm_;
};

/// The similarity from the frame of a camera to the world, and the known parameters of two cameras: `second`
/// is the camera in whose frame the world is. ⊞ is that of Sim3, and changes only the similarity. The tag in
/// g2o files is VERTEX_SIM3:EXPMAP.
template <class S>
struct BasicSimilarityCamera {
  using Scalar = S;
  static constexpr std::string_view kName = "SimilarityCamera";
  /// A LoggedSim3 if S is double, otherwise a BasicSim3<S>.
  using Similarity = std::conditional_t<std::is_same_v<S, double>, LoggedSim3, BasicSim3<S>>;
  Similarity similarity;
  PinholeCamera first = PinholeCamera(1, 1, 0, 0), second = PinholeCamera(1, 1, 0, 0);

  const BasicSim3<S>& pose() const {
    if constexpr (std::is_same_v<S, double>) {
      return similarity.value();
    } else {
      return similarity;
    }
  }
};

using SimilarityCamera = BasicSimilarityCamera<double>;

template <class S>
struct Manifold<BasicSimilarityCamera<S>> {
  using Point = BasicSimilarityCamera<S>;
  template <class T>
  using Rebind = BasicSimilarityCamera<T>;
  static constexpr int kDim = 7;

  template <class D>
  static Rebind<detail::Promoted<S, D>> oplus(const Point& x, const D* delta) {
    if constexpr (std::is_same_v<D, double> && std::is_same_v<S, double>) {
      bool is_zero = true;  // a zero step changes no bit
      for (int i = 0; i < kDim; ++i) is_zero = is_zero && delta[i] == 0;
      if (is_zero) return x;
    }
    using T = detail::Promoted<S, D>;
    return {typename Rebind<T>::Similarity(Manifold<BasicSim3<S>>::oplus(x.pose(), delta)), x.first,
            x.second};
  }
  template <class D>
  static void ominus(const Point& y, const Point& x, D* delta) {
    Manifold<BasicSim3<S>>::ominus(y.pose(), x.pose(), delta);
  }
  template <class T>
  static Rebind<T> cast(const Point& x) {
    if constexpr (std::is_same_v<T, S>) return x;
    return {typename Rebind<T>::Similarity(x.pose().template cast<T>()), x.first, x.second};
  }
};

/// The position and the rotation. A new frame keeps the scale.
template <>
struct detail::FrameTrait<SimilarityCamera> {
  static Frame get(const SimilarityCamera& x) {
    return FrameTrait<SE3>::get(SE3::from_unit(x.pose().translation(), x.pose().quaternion()));
  }
  static void set(SimilarityCamera& x, const Frame& frame) {
    SE3 pose;
    FrameTrait<SE3>::set(pose, frame);
    x.similarity = LoggedSim3(Sim3(pose.quaternion(), pose.translation(), x.pose().scale()));
  }
};

namespace detail {

/// Y⁻¹ p.
template <class S, class Point>
Vector<S, 3> inverse_times(const BasicSim3<S>& Y, const Point& p) {
  const Vector<S, 3> t = Y.translation();
  const Vector<S, 3> b = rotate(Y.quaternion().conjugate(), S(p[0] - t[0]), S(p[1] - t[1]), S(p[2] - t[2]));
  return b / Y.scale();
}

/// The derivatives of the image with respect to the point.
inline Matrix<double, 2, 3> image_by_point(const PinholeCamera& camera, const Vector3& p) {
  Matrix<double, 2, 3> J;
  Matrix<double, 2, PinholeCamera::kSize> unused;
  camera.project(p, J, unused);
  return J;
}

}  // namespace detail

/// z measures the similarity of b relative to a. Error: (ω, υ, σ) = log(z⁻¹ a⁻¹ b). The tag in g2o files is
/// EDGE_SIM3:EXPMAP.
struct SimilarityBetween {
  static constexpr std::string_view kName = "SimilarityBetween";
  LoggedSim3 measurement;

  explicit SimilarityBetween(const LoggedSim3& z) : measurement(z) {}

  template <class S>
  Vector<S, 7> error(const BasicSimilarityCamera<S>& a, const BasicSimilarityCamera<S>& b) const {
    return detail::difference(detail::motion_between(a.pose(), b.pose()), measurement.value());
  }
};

/// z measures the pixel of the point l in the first camera of Y. Error: first(Y⁻¹ l) − z, in pixels.
/// Vertices: l, Y. The tag in g2o files is EDGE_PROJECT_SIM3_XYZ:EXPMAP.
struct SimilarityImage {
  static constexpr std::string_view kName = "SimilarityImage";
  static constexpr bool kJacobiansForSomeTypes = true;
  Vector2 measurement;

  explicit SimilarityImage(const Vector2& z) : measurement(z) {}

  template <class S, class Point>
  Vector<S, 2> error(const Point& point, const BasicSimilarityCamera<S>& Y) const {
    return Y.first.project(detail::inverse_times(Y.pose(), point)) - measurement;
  }

  template <class A, class B>
  void jacobians(const Vector3& point, const SimilarityCamera& Y, A& J_point, B& J_camera) const {
    const Vector3 b = detail::inverse_times(Y.pose(), point);
    const Matrix<double, 2, 3> J = detail::image_by_point(Y.first, b);
    J_point = J * Y.pose().rotation().transpose() / Y.pose().scale();
    J_camera << J * detail::cross_matrix(b[0], b[1], b[2]), -J, -J * b;
  }
};

/// z measures the pixel in the second camera of a point p, which is given in the frame of the first camera.
/// Error: second(Y p) − z, in pixels. Vertices: p, Y. The tag in g2o files is
/// EDGE_PROJECT_INVERSE_SIM3_XYZ:EXPMAP.
struct InverseSimilarityImage {
  static constexpr std::string_view kName = "InverseSimilarityImage";
  static constexpr bool kJacobiansForSomeTypes = true;
  Vector2 measurement;

  explicit InverseSimilarityImage(const Vector2& z) : measurement(z) {}

  template <class S, class Point>
  Vector<S, 2> error(const Point& point, const BasicSimilarityCamera<S>& Y) const {
    return Y.second.project(Y.pose() * point) - measurement;
  }

  template <class A, class B>
  void jacobians(const Vector3& p, const SimilarityCamera& Y, A& J_point, B& J_camera) const {
    J_point = Y.pose().scale() * detail::image_by_point(Y.second, Y.pose() * p) * Y.pose().rotation();
    J_camera << -J_point * detail::cross_matrix(p[0], p[1], p[2]), J_point, J_point * p;
  }
};

}  // namespace boxplus
