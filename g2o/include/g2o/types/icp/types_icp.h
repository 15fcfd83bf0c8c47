// SPDX-License-Identifier: BSD-3-Clause
// Edges for pairs of points with normals (Segal, Haehnel, Thrun, "Generalized-ICP", 2009), and stereo cameras
// that share one camera matrix.
#pragma once
#ifndef G2O_TYPES_ICP
#define G2O_TYPES_ICP

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/icp/g2o_types_icp_api.h"
#include "g2o/types/sba/types_sba.h"
#include "g2o/types/slam3d/types_slam3d.h"

namespace g2o {

/// A pair of matching points of two scans, with their surface normals. pos0 and normal0 are in the frame of
/// the first pose, and pos1 and normal1 are in the frame of the second pose.
class G2O_TYPES_ICP_API EdgeGICP {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgeGICP();

  /// Update R0 and R1 from the normals. The rows of R are n × a, a and n, which form a left-handed frame. n
  /// is the normal, and a is the unit vector that is orthogonal to n and closest to the y-axis, or to the
  /// x-axis if n is parallel to the y-axis (within 1e-3 rad). As in g2o, n is not normalized.
  void makeRot0();
  void makeRot1();

  /// Return the precision matrix of a point with a unit normal. The precision is 1 along the normal, and e in
  /// the plane that is orthogonal to the normal.
  Matrix3 prec0(double e);
  Matrix3 prec1(double e);
  /// Return the covariance of a point with a unit normal. The variance is e along the normal, and 1 in the
  /// plane that is orthogonal to the normal.
  Matrix3 cov0(double e);
  Matrix3 cov1(double e);

  Vector3 pos0 = Vector3::Zero(), pos1 = Vector3::Zero();
  Vector3 normal0 = Vector3(0, 0, 1), normal1 = Vector3(0, 0, 1);
  Matrix3 R0 = Matrix3::Identity(), R1 = Matrix3::Identity();
};

/// Two matching points: p₀ in the frame of pose x₀, and p₁ in the frame of pose x₁. Error: x₀⁻¹ x₁ p₁ − p₀.
/// read() sets Ω to the precision matrix prec0(0.01) of p₀. Tag: EDGE_V_V_GICP.
class G2O_TYPES_ICP_API Edge_V_V_GICP : public BaseBinaryEdge<3, EdgeGICP, VertexSE3, VertexSE3> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  Edge_V_V_GICP() = default;
  /// Copies the vertices, the measurement, pl_pl, cov0 and cov1 of `e`. As in g2o, Ω is the identity, and the
  /// copy has no robust kernel.
  explicit Edge_V_V_GICP(const Edge_V_V_GICP* e);

  /// If pl_pl (plane to plane) is true, also sets Ω to (cov0 + R cov1 Rᵀ)⁻¹, with the rotation R of x₀⁻¹ x₁.
  void computeError() override;
  void linearizeOplus() override;
  using BaseBinaryEdge<3, EdgeGICP, VertexSE3, VertexSE3>::linearizeOplus;
  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

  bool pl_pl = false;
  Matrix3 cov0 = Matrix3::Identity(), cov1 = Matrix3::Identity();
};

/// The pose of a stereo camera. All objects share one camera matrix and baseline.
class G2O_TYPES_ICP_API VertexSCam : public VertexSE3 {
 public:
  using UsedByEdges = VertexSCam;
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  VertexSCam();

  /// Set m to a 3×4 matrix that transforms points. transformW2F() transforms from the world frame to the
  /// frame of the pose (trans, qrot), and transformF2W() transforms back.
  static void transformW2F(Eigen::Matrix<double, 3, 4>& m, const Vector3& trans, const Quaternion& qrot);
  static void transformF2W(Eigen::Matrix<double, 3, 4>& m, const Vector3& trans, const Quaternion& qrot);

  /// Sets Kcam and baseline. Not thread-safe: no other thread may use a VertexSCam at the same time.
  static void setKcam(double fx, double fy, double cx, double cy, double tx);

  /// Each function updates members that depend on the estimate and Kcam. setTransform() updates w2n,
  /// setProjection() updates w2i, setDr() updates dRdx, dRdy and dRdz, and setAll() updates all of them.
  void setTransform();
  void setProjection();
  void setDr();
  void setAll();
  /// Computes the image coordinates of a world point: u, v, and u in the right camera.
  void mapPoint(Vector3& res, const Vector3& pt3) const;

  static Matrix3 Kcam;
  static double baseline;
  Eigen::Matrix<double, 3, 4> w2n;  ///< matrix from the world frame to the camera frame
  Eigen::Matrix<double, 3, 4> w2i;  ///< matrix from the world frame to the image
  Matrix3 dRdx, dRdy, dRdz;         ///< derivatives of the rotation in w2n by increments of qx, qy, qz
};

/// The measured image coordinates z (pixels) of a point in a stereo camera. Error: (u, v, u_right) − z. The
/// type has no tag.
class G2O_TYPES_ICP_API Edge_XYZ_VSC
    : public ReadyMadeEdge<Edge_XYZ_VSC, 3, Vector3, VertexPointXYZ, VertexSCam> {
 public:
  Edge_XYZ_VSC();
};

}  // namespace g2o

#endif  // G2O_TYPES_ICP
