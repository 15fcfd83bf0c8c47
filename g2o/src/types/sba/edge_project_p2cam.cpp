// SPDX-License-Identifier: BSD-3-Clause
// Edges for the image of a point in an SBACam, as a single camera or as a stereo pair.
#include "g2o/types/sba/edge_project_p2mc.h"
#include "g2o/types/sba/edge_project_p2sc.h"
#include "types/ready_made_edge.h"
#include "types/sba/adapters_sba.h"

namespace g2o {
namespace {

Vector3 in_camera(const SBACam& cam, const Vector3& point) {
  return cam.w2n * point.homogeneous();
}

double baseline_times_focal_length(const SBACam& cam) {
  return cam.Kcam(0, 0) * cam.baseline;
}

/// Computes the Jacobians of the image. The engine's tangent of a pose has the translation in the frame of
/// the camera, and g2o's in the world frame.
template <int Rows, class JPoint, class JCam>
void linearize(const SBACam& cam, const Vector3& point, JPoint& J_point, JCam& J_cam) {
  const Vector3 p = in_camera(cam, point);
  const auto D = adapters::image_by_point<Rows>(cam.Kcam, baseline_times_focal_length(cam), p);
  Eigen::Matrix<double, 3, 6> p_by_cam;
  Matrix3 p_by_point;
  boxplus::PointObservation3(p).jacobians(adapters::pose(cam), boxplus::Vector3(point), p_by_cam, p_by_point);
  J_point = D * p_by_point;
  J_cam = D * p_by_cam;
  J_cam.template leftCols<3>() *= cam.w2n.leftCols<3>();
}

}  // namespace

namespace internal {

template <class Edge>
struct CameraVertexModel {
  static typename Edge::Measurement error(const Edge& e) {
    const SBACam& cam = estimate<1>(e);
    return adapters::image<Edge::Dimension>(cam.Kcam, baseline_times_focal_length(cam),
                                            in_camera(cam, estimate<0>(e))) -
           e.measurement();
  }
  static void linearize(Edge& e) {
    g2o::linearize<Edge::Dimension>(estimate<1>(e), estimate<0>(e), e.template jacobianOplusXn<0>(),
                                    e.template jacobianOplusXn<1>());
  }
};
template <>
struct EdgeModel<EdgeProjectP2MC> : CameraVertexModel<EdgeProjectP2MC> {};
template <>
struct EdgeModel<EdgeProjectP2SC> : CameraVertexModel<EdgeProjectP2SC> {};

template struct EdgeFunctions<EdgeProjectP2MC>;
template struct EdgeFunctions<EdgeProjectP2SC>;

}  // namespace internal

EdgeProjectP2MC::EdgeProjectP2MC() = default;
EdgeProjectP2SC::EdgeProjectP2SC() = default;

}  // namespace g2o
