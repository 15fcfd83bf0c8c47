// SPDX-License-Identifier: BSD-3-Clause
// Pixels with a measured depth, from a camera that is mounted on a robot.
//
// The derivatives are those of the point p in the frame of the camera (types/slam3d/point_observation.h),
// multiplied by the derivative of the image with respect to p.
#pragma once

#include <string_view>

#include "boxplus/manifold/product.h"
#include "boxplus/manifold/se3.h"
#include "boxplus/types/ba/stereo_camera.h"
#include "boxplus/types/slam3d/point_observation.h"

namespace boxplus {

namespace detail {

/// What a sensor measures besides the pixel.
enum class DepthKind { kDepth, kInverseDepth };

}  // namespace detail

/// z measures the pixel (u, v) of the point l and, for a point p = C⁻¹ X⁻¹ l in the frame of the camera, the
/// depth p_z (meters) or the inverse depth 1/p_z. Error: (u, v, p_z) − z or (u, v, 1/p_z) − z. Vertices: the
/// pose X of the robot, l, and the camera: its pose C on the robot, and its parameters. Near p_z = 0, 1/p_z
/// is replaced by a smooth function, as in BasicCamera. The tags in g2o files are EDGE_PROJECT_DEPTH and
/// EDGE_PROJECT_DISPARITY, and PARAMS_CAMERACALIB for the camera.
template <detail::DepthKind kKind>
struct PixelWithDepth {
  static constexpr std::string_view kName =
      kKind == detail::DepthKind::kDepth ? "DepthImage" : "DisparityImage";
  static constexpr bool kJacobiansForSomeTypes = true;
  Vector3 measurement;

  explicit PixelWithDepth(const Vector3& z) : measurement(z) {}

  template <class S, class Chart, class Point>
  Vector<S, 3> error(const BasicSE3<S, Chart>& pose, const Point& point,
                     const Product<BasicSE3<S, Chart>, BasicCamera<detail::PinholeModel, S>>& camera) const {
    const Vector<S, 3> p = camera.template get<0>().inverse_times(pose.inverse_times(point));
    const Vector<S, 2> pixel = camera.template get<1>().project(p);
    const S third = kKind == detail::DepthKind::kDepth ? S(p[2]) : detail::inverse(S(p[2])).value;
    return {pixel[0] - measurement[0], pixel[1] - measurement[1], third - measurement[2]};
  }

  template <class A, class B, class C>
  void jacobians(const SE3& pose, const Vector3& point, const Product<SE3, PinholeCamera>& camera, A& J_pose,
                 B& J_point, C& J_camera) const {
    const SE3& offset = camera.template get<0>();
    const Vector3 p = offset.inverse_times(pose.inverse_times(point));
    const detail::ImageDerivatives<2> by({camera.template get<1>(), 0}, p);
    Matrix<double, 3, 3> J;
    J << by.by_point(), 0, 0, kKind == detail::DepthKind::kDepth ? 1 : detail::inverse(p[2]).slope;
    auto J_offset = J_camera.template leftCols<6>();
    OffsetPointObservation3(p).jacobians(pose, point, offset, J_pose, J_point, J_offset);
    J_pose = (J * J_pose).eval();
    J_point = (J * J_point).eval();
    J_offset = (J * J_offset).eval();
    J_camera.template rightCols<4>() << by.by_parameters().template leftCols<4>(),
        Matrix<double, 1, 4>::Zero();
  }
};

using DepthImage = PixelWithDepth<detail::DepthKind::kDepth>;
using DisparityImage = PixelWithDepth<detail::DepthKind::kInverseDepth>;

}  // namespace boxplus
