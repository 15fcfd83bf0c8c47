// SPDX-License-Identifier: BSD-3-Clause
// A point in space, seen in an image.
//
// Let b = X⁻¹ l be the point in the frame of the camera (or of the rig) at the pose X = T_world_camera, and J
// the derivative of the pixel with respect to b. As in types/slam3d/point_observation.h:
//   ∂e/∂X = J [ −I  2 [b]× ]    ∂e/∂l = J R_Xᵀ
// On a rig, the sensor is at P: p = P⁻¹ b, and J is the derivative with respect to p.
//   ∂e/∂X = J R_Pᵀ [ −I  2 [b]× ]    ∂e/∂P = J [ −I  2 [p]× ]    ∂e/∂l = J R_Pᵀ R_Xᵀ
#pragma once

#include <utility>

#include "boxplus/manifold/product.h"
#include "boxplus/manifold/se3.h"
#include "boxplus/types/ba/camera_models.h"
#include "boxplus/types/slam3d/between_jacobians.h"
#include "boxplus/types/type_label.h"

namespace boxplus {

namespace detail {
struct ReprojectionText {
  static constexpr std::string_view kText = "Reprojection";
};
struct CalibratedReprojectionText {
  static constexpr std::string_view kText = "CalibratedReprojection";
};

/// J_pose ← J [ −I  2 [b]× ].
template <class A>
void pose_jacobian(const Matrix<double, 2, 3>& J, const Vector3& b, A&& J_pose) {
  J_pose.template leftCols<3>() = -J;
  J_pose.template rightCols<3>() = 2 * J * cross_matrix(b[0], b[1], b[2]);
}
}  // namespace detail

/// z measures the pixel at which a camera sees the point l. Error: project(X⁻¹ l) − z, in pixels. Vertices:
///   X, l, camera        pose of the camera (T_world_camera), point, intrinsic parameters
///   (X, camera), l      pose and parameters in one vertex: Product<SE3, Camera>
///   X, l, P, camera     pose of a rig, point, pose of the sensor on the rig (T_rig_camera), parameters
/// Several poses may share a camera. The error is finite for every point, also for one that the camera does
/// not see: then the formula of the camera is continued (BasicCamera).
template <class Camera>
struct Reprojection {
  static constexpr std::string_view kName = detail::TypeLabel<detail::ReprojectionText, Camera>::kValue;
  static constexpr bool kJacobiansForSomeTypes = true;
  template <class S>
  using CameraOver = BasicCamera<typename Camera::Model, S>;
  Vector2 measurement;

  explicit Reprojection(const Vector2& z) : measurement(z) {}

  template <class S, class Chart, class Point>
  Vector<S, 2> error(const BasicSE3<S, Chart>& pose, const Point& point, const CameraOver<S>& camera) const {
    return camera.project(pose.inverse_times(point)) - measurement;
  }
  template <class S, class Chart, class Point>
  Vector<S, 2> error(const Product<BasicSE3<S, Chart>, CameraOver<S>>& camera, const Point& point) const {
    return error(camera.template get<0>(), point, camera.template get<1>());
  }
  template <class S, class Chart, class Point>
  Vector<S, 2> error(const BasicSE3<S, Chart>& pose, const Point& point, const BasicSE3<S, Chart>& offset,
                     const CameraOver<S>& camera) const {
    return camera.project(offset.inverse_times(pose.inverse_times(point))) - measurement;
  }

  template <class A, class B, class C>
  void jacobians(const SE3& pose, const Vector3& point, const Camera& camera, A& J_pose, B& J_point,
                 C& J_camera) const {
    fill(pose, point, camera, J_pose, J_point, J_camera);
  }
  template <class A, class B>
  void jacobians(const Product<SE3, Camera>& camera, const Vector3& point, A& J_camera, B& J_point) const {
    fill(camera.template get<0>(), point, camera.template get<1>(), J_camera.template leftCols<6>(), J_point,
         J_camera.template rightCols<Camera::kSize>());
  }
  template <class A, class B, class C, class D>
  void jacobians(const SE3& pose, const Vector3& point, const SE3& offset, const Camera& camera, A& J_pose,
                 B& J_point, C& J_offset, D& J_camera) const {
    const Vector3 b = pose.inverse_times(point), p = offset.inverse_times(b);
    Matrix<double, 2, 3> J;
    camera.project(p, J, J_camera);
    const Matrix<double, 2, 3> J_b = J * offset.rotation().transpose();
    detail::pose_jacobian(J, p, J_offset);
    detail::pose_jacobian(J_b, b, J_pose);
    J_point = J_b * pose.rotation().transpose();
  }

 private:
  template <class A, class B, class C>
  static void fill(const SE3& pose, const Vector3& point, const Camera& camera, A&& J_pose, B&& J_point,
                   C&& J_camera) {
    const Vector3 b = pose.inverse_times(point);
    Matrix<double, 2, 3> J;
    camera.project(b, J, J_camera);
    detail::pose_jacobian(J, b, J_pose);
    J_point = J * pose.rotation().transpose();
  }
};

/// The same with known intrinsic parameters, which are part of the edge. Vertices: X, l.
template <class Camera>
struct CalibratedReprojection {
  static constexpr std::string_view kName =
      detail::TypeLabel<detail::CalibratedReprojectionText, Camera>::kValue;
  static constexpr bool kJacobiansForSomeTypes = true;
  Vector2 measurement;
  Camera camera;

  CalibratedReprojection(const Vector2& z, Camera known) : measurement(z), camera(std::move(known)) {}

  template <class S, class Chart, class Point>
  Vector<S, 2> error(const BasicSE3<S, Chart>& pose, const Point& point) const {
    return camera.project(pose.inverse_times(point)) - measurement;
  }

  template <class A, class B>
  void jacobians(const SE3& pose, const Vector3& point, A& J_pose, B& J_point) const {
    const Vector3 b = pose.inverse_times(point);
    Matrix<double, 2, 3> J;
    Matrix<double, 2, Camera::kSize> unused;
    camera.project(b, J, unused);
    detail::pose_jacobian(J, b, J_pose);
    J_point = J * pose.rotation().transpose();
  }
};

}  // namespace boxplus

#include "boxplus/types/ba/reprojection_lanes.h"  // IWYU pragma: export
