// SPDX-License-Identifier: BSD-3-Clause
// Images of points in rectified stereo cameras, or in the first camera of such a pair: the projection edges
// of g2o. Here, the point is the first vertex, as in g2o's files.
//
// Let b = X⁻¹ l be the point in the frame of the camera at the pose X = T_world_camera, and J the derivative
// of the image with respect to b. In the tangent (Δt, ω) of SE3RotationVector:
//   ∂e/∂X = J [ −I  [b]× ]    ∂e/∂l = J R_Xᵀ
// SE3 has half angles instead of ω, so its last three columns are twice these.
#pragma once

#include <string_view>
#include <utility>

#include "boxplus/types/ba/stereo_camera.h"
#include "boxplus/types/slam3d/between_jacobians.h"

namespace boxplus {

namespace detail {

/// The angle (radians) of a unit of the rotational tangent.
template <class Chart>
inline constexpr double kAngleUnit = std::is_same_v<Chart, QuaternionChart> ? 2 : 1;

/// J_pose ← the derivatives by the pose.
template <class Chart, int Rows, class A>
void image_by_pose(const ImageDerivatives<Rows>& by, A&& J_pose) {
  by.by_pose(J_pose.template leftCols<3>(), J_pose.template rightCols<3>());
  if constexpr (kAngleUnit<Chart> != 1) J_pose.template rightCols<3>() *= kAngleUnit<Chart>;
}

template <int Rows>
constexpr std::string_view image_name(std::string_view of_one, std::string_view of_pair) {
  return Rows == 2 ? of_one : of_pair;
}

}  // namespace detail

/// z measures the pixel (u, v) of the point l (Rows = 2), or the pixel and its column in the second camera
/// (Rows = 3). Error: image(X⁻¹ l) − z, in pixels. Vertices, and tags in g2o files for Rows = 2 and 3:
///   l, X, StereoCamera          EDGE_PROJECT_XYZ2UV:EXPMAP, EDGE_PROJECT_XYZ2UVU:EXPMAP, if X is an
///                               SE3RotationVector. X may also be an SE3.
///   l, StereoPose               EDGE_PROJECT_P2MC, EDGE_PROJECT_P2SC
///   l, StereoPose, StereoIntrinsics   EDGE_PROJECT_P2MC_INTRINSICS. The intrinsics of the pose are not used.
/// Of points that the camera does not see, the error is that of BasicCamera. (g2o's error is z − image().)
template <int Rows>
struct PointImage {
  static constexpr std::string_view kName = detail::image_name<Rows>("PointImage", "StereoPointImage");
  static constexpr bool kJacobiansForSomeTypes = true;
  Vector<double, Rows> measurement;

  explicit PointImage(const Vector<double, Rows>& z) : measurement(z) {}

  template <class S, class Chart, class Point>
  Vector<S, Rows> error(const Point& point, const BasicSE3<S, Chart>& pose,
                        const BasicStereoCamera<S>& camera) const {
    return camera.pinhole().template image<Rows>(pose.inverse_times(point)) - measurement;
  }
  template <class S, class Point>
  Vector<S, Rows> error(const Point& point, const BasicStereoPose<S>& camera) const {
    return camera.pinhole().template image<Rows>(camera.pose.inverse_times(point)) - measurement;
  }
  template <class S, class Point>
  Vector<S, Rows> error(const Point& point, const BasicStereoPose<S>& camera,
                        const BasicStereoIntrinsics<S>& intrinsics) const {
    return intrinsics.pinhole().template image<Rows>(camera.pose.inverse_times(point)) - measurement;
  }

  template <class Chart, class A, class B, class C>
  void jacobians(const Vector3& point, const BasicSE3<double, Chart>& pose, const StereoCamera& camera,
                 A& J_point, B& J_pose, C& J_camera) const {
    const auto by = fill(point, pose, camera.pinhole(), J_point, J_pose);
    J_camera.col(0) = by.col(0) + by.col(1) + by.col(4) * camera.parameters[3];
    J_camera.template middleCols<2>(1) = by.template middleCols<2>(2);
    J_camera.col(3) = by.col(4) * camera.parameters[0];
  }
  template <class A, class B>
  void jacobians(const Vector3& point, const StereoPose& camera, A& J_point, B& J_camera) const {
    fill(point, camera.pose, camera.pinhole(), J_point, J_camera);
  }
  template <class A, class B, class C>
  void jacobians(const Vector3& point, const StereoPose& camera, const StereoIntrinsics& intrinsics,
                 A& J_point, B& J_camera, C& J_intrinsics) const {
    const auto by = fill(point, camera.pose, intrinsics.pinhole(), J_point, J_camera);
    J_intrinsics = by.template leftCols<4>();
    J_intrinsics.col(0) += by.col(4) * intrinsics.baseline;
  }

 private:
  /// Returns the derivatives with respect to fx, fy, cx, cy and bf.
  template <class Chart, class A, class B>
  static Matrix<double, Rows, 5> fill(const Vector3& point, const BasicSE3<double, Chart>& pose,
                                      const detail::StereoPinhole<double>& camera, A& J_point, B& J_pose) {
    const Vector3 b = pose.inverse_times(point);
    const detail::ImageDerivatives<Rows> by(camera, b);
    detail::image_by_pose<Chart>(by, J_pose);
    by.by_rotated_point(pose.rotation().transpose(), J_point);
    return by.by_parameters();
  }
};

/// The same with known parameters of the camera, which are part of the edge. Vertices: l, X. The tags in g2o
/// files are EDGE_SE3_PROJECT_XYZ:EXPMAP and EDGE_STEREO_SE3_PROJECT_XYZ:EXPMAP.
template <int Rows>
struct CalibratedPointImage {
  static constexpr std::string_view kName =
      detail::image_name<Rows>("CalibratedPointImage", "CalibratedStereoPointImage");
  static constexpr bool kJacobiansForSomeTypes = true;
  Vector<double, Rows> measurement;
  PinholeCamera camera;
  double bf = 0;  ///< fx · baseline; not used if Rows = 2

  CalibratedPointImage(const Vector<double, Rows>& z, PinholeCamera known, double known_bf = 0)
      : measurement(z), camera(std::move(known)), bf(known_bf) {}

  template <class S, class Chart, class Point>
  Vector<S, Rows> error(const Point& point, const BasicSE3<S, Chart>& pose) const {
    const detail::StereoPinhole<S> pinhole{Manifold<PinholeCamera>::cast<S>(camera), S(bf)};
    return pinhole.template image<Rows>(pose.inverse_times(point)) - measurement;
  }

  template <class Chart, class A, class B>
  void jacobians(const Vector3& point, const BasicSE3<double, Chart>& pose, A& J_point, B& J_pose) const {
    const Vector3 b = pose.inverse_times(point);
    const detail::ImageDerivatives<Rows> by({camera, bf}, b);
    detail::image_by_pose<Chart>(by, J_pose);
    by.by_rotated_point(pose.rotation().transpose(), J_point);
  }
};

/// The same with a known point, too. Vertex: X. The tags in g2o files are EDGE_SE3_PROJECT_XYZONLYPOSE:EXPMAP
/// and EDGE_STEREO_SE3_PROJECT_XYZONLYPOSE:EXPMAP.
template <int Rows>
struct KnownPointImage {
  static constexpr std::string_view kName =
      detail::image_name<Rows>("KnownPointImage", "StereoKnownPointImage");
  static constexpr bool kJacobiansForSomeTypes = true;
  Vector<double, Rows> measurement;
  Vector3 point;
  PinholeCamera camera;
  double bf = 0;

  KnownPointImage(const Vector<double, Rows>& z, const Vector3& known_point, PinholeCamera known,
                  double known_bf = 0)
      : measurement(z), point(known_point), camera(std::move(known)), bf(known_bf) {}

  template <class S, class Chart>
  Vector<S, Rows> error(const BasicSE3<S, Chart>& pose) const {
    return CalibratedPointImage<Rows>(measurement, camera, bf).error(point, pose);
  }

  template <class Chart, class A>
  void jacobians(const BasicSE3<double, Chart>& pose, A& J_pose) const {
    const detail::ImageDerivatives<Rows> by({camera, bf}, pose.inverse_times(point));
    detail::image_by_pose<Chart>(by, J_pose);
  }
};

}  // namespace boxplus
