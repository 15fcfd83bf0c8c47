// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "g2o/core/block_solver.h"
#include "g2o/core/optimization_algorithm_levenberg.h"
#include "g2o/edge_checks.h"
#include "g2o/solvers/dense/linear_solver_dense.h"
#include "g2o/types/slam3d_addons/types_slam3d_addons.h"

G2O_USE_TYPE_GROUP(slam3d);
G2O_USE_TYPE_GROUP(slam3d_addons);

namespace {

using edge_checks::omega;
using g2o::Plane3D;

Plane3D plane(double x, double y, double z, double distance) {
  const g2o::Vector3 n = g2o::Vector3(x, y, z).normalized();
  return Plane3D(g2o::Vector4(n.x(), n.y(), n.z(), -distance));
}

TEST(Slam3dAddons, AllTypesHaveExactJacobiansAndAreWrittenAsTheyWereRead) {
  edge_checks::expect_laws_of_file(
      "PARAMS_SE3OFFSET 0 0.3 -0.2 0.1 0.1 0.7 0.5 0.5\n"
      "VERTEX_SE3:QUAT 0 1 2 3 0.5 0.5 0.5 0.5\n"
      "VERTEX_SE3:QUAT 1 0.3 0.1 -0.2 0.1 -0.1 0.7 0.7\n"
      "VERTEX_PLANE 2 0.48 0.6 0.64 -2 0.1 0.2 0.3\n"
      "VERTEX_PLANE 3 0.8 0 0.6 1 0.1 0.2 0.3\n"
      "VERTEX_SE3:QUAT 4 1.3 1.1 2.2 0.5 -0.5 0.5 0.5\n"
      "VERTEX3 5 1 2 3 0.1 -0.2 0.3\n"
      "VERTEX3 6 2 1 3 0.3 0.4 -1.3\n"
      "VERTEX_LINE3D 7 -1.84 -0.62 1.2 0.36 0.48 0.8\n"
      "EDGE_SE3_PLANE_CALIB 0 2 1 0.6 0.48 0.64 1 0.4 0.5 0.6" +
      omega(3) +
      "\n"
      "EDGE_SE3_CALIB 0 4 1 0.3 0.2 0.1 0.5 0.5 -0.5 0.5" +
      omega(6) +
      "\n"
      "EDGE_PLANE 2 3 0.1 0.2 0.3 0.4" +
      omega(4) +
      "\n"
      "EDGE3 5 6 1.1 -0.9 0.1 0.2 0.5 -1.5" +
      omega(6) +
      "\n"
      "EDGE_SE3_LINE3D 0 7 0 -3 -1.6 1.2 0 0.6 0.8" +
      omega(4) + "\n");
}

// For a small rotation, the rotation error of the edge is half of the angle. The information matrix in the
// file is for the angle itself, so chi2 must be the same as for an error that is the full angle.
TEST(Slam3dAddons, TheInformationMatrixOfAToroEdgeWeightsAngles) {
  g2o::SparseOptimizer optimizer;
  std::istringstream in(
      "VERTEX3 0 0 0 0 0 0 0\nVERTEX3 1 1 0 0 1e-4 0 0\nEDGE3 0 1 1.2 0 0 0 0 0 "
      "25 0 0 0 0 0 1 0 0 0 0 1 0 0 0 9 0 0 1 0 1\n");
  ASSERT_TRUE(optimizer.load(in));
  auto* e = static_cast<g2o::EdgeSE3Euler*>(*optimizer.edges().begin());
  e->computeError();
  EXPECT_NEAR(e->chi2(), 25 * 0.04 + 9e-8, 1e-14);
}

/// A client's pose that has the base of VertexSE3, but not the members that edges on VertexSE3 read.
class OwnPose : public g2o::BaseVertex<6, g2o::Isometry3> {
 public:
  void setToOriginImpl() override { _estimate.setIdentity(); }
  void oplusImpl(const double*) override {}
  bool read(std::istream&) override { return false; }
  bool write(std::ostream&) const override { return false; }
};

TEST(Slam3dAddons, EdgesAcceptOtherVertexClassesUnlessTheyReadMembersThatTheseLack) {
  g2o::SparseOptimizer optimizer;
  std::istringstream in(
      "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\nVERTEX_SE3:QUAT 1 1 0 0 0 0 0 1\nEDGE3 0 1 1.5 0 0 0 0 0" + omega(6) +
      "\n");
  ASSERT_TRUE(optimizer.load(in));
  ASSERT_EQ(optimizer.edges().size(), 1u);
  auto* e = static_cast<g2o::EdgeSE3Euler*>(*optimizer.edges().begin());
  e->computeError();
  EXPECT_NEAR(e->error()[0], -0.5, 1e-12);

  auto* own = new OwnPose;
  own->setId(2);
  ASSERT_TRUE(optimizer.addVertex(own));
  auto other = std::make_unique<g2o::EdgeSE3>();
  other->setVertex(0, optimizer.vertex(0));
  other->setVertex(1, own);
  EXPECT_FALSE(optimizer.addEdge(other.get()));
}

TEST(Slam3dAddons, ErrorsFollowTheSignConventionsOfTheFileFormat) {
  // The azimuth of the normal that EDGE_SE3_PLANE_CALIB measures is 0.1.
  // The line is 2 m from the body, 1 m from the sensor, and 2 m away in the measurement.
  edge_checks::expect_errors(
      "PARAMS_SE3OFFSET 0 0 1 0 0 0 0 1\n"
      "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\n"
      "VERTEX_SE3:QUAT 1 0.5 0 0 0 0 0 1\n"
      "VERTEX_SE3:QUAT 2 1.5 0 0 0 0 0 1\n"
      "VERTEX_PLANE 3 1 0 0 -2 0 0 0\n"
      "VERTEX_PLANE 4 0 1 0 -1 0 0 0\n"
      "VERTEX_LINE3D 5 0 0 -2 1 0 0\n"
      "EDGE_SE3_PLANE_CALIB 0 3 1 0.9950041652780258 0.09983341664682815 0 -1 0 0 0" +
          omega(3) +
          "\n"
          "EDGE_SE3_CALIB 0 2 1 0 0 0 0 0 0 1" +
          omega(6) +
          "\n"
          "EDGE_PLANE 3 4 0 0 0 3" +
          omega(4) +
          "\n"
          "EDGE_SE3_LINE3D 0 5 0 0 0 -2 1 0 0" +
          omega(4) + "\n",
      {{"EDGE_SE3_PLANE_CALIB", {0.1, 0, 0.5}},
       {"EDGE_SE3_CALIB", {1.5, 0, 0, 0, 0, 0}},
       {"EDGE_PLANE", {-1, 1, 0, -2}},
       {"EDGE_SE3_LINE3D", {0, 0, 0, std::atan(0.5) - std::atan(1)}}});
}

TEST(Planes, AreNormalizedWhenSet) {
  g2o::VertexPlane v;
  v.setEstimate(Eigen::Vector4d(0, 3, 4, 10));
  EXPECT_LT((v.estimate().coeffs() - g2o::Vector4(0, 0.6, 0.8, 2)).norm(), 1e-15);
}

TEST(Planes, AreNotMovedByAZeroStep) {
  for (const Plane3D& p : {plane(1, 0, 0, 1), plane(0.3, -0.4, 0.5, -2), plane(0, 0, 1, 3)}) {
    Plane3D moved = p;
    moved.oplus(g2o::Vector3::Zero());
    EXPECT_LT((moved.coeffs() - p.coeffs()).norm(), 1e-15);
  }
}

// The distance that ominus() returns and the distance that oplus() expects have opposite signs.
TEST(Planes, OplusUndoesOminusIfTheDistanceIsNegated) {
  const Plane3D from = plane(0.3, -0.4, 0.5, -2), to = plane(-0.1, 0.7, 0.2, 1.5);
  const g2o::Vector3 d = from.ominus(to);
  Plane3D moved = from;
  moved.oplus(g2o::Vector3(d[0], d[1], -d[2]));
  EXPECT_LT((moved.coeffs() - to.coeffs()).norm(), 1e-14);
  EXPECT_NEAR(d[2], -3.5, 1e-15);
}

TEST(Planes, AreMovedTogetherWithTheirPoints) {
  g2o::Vector6 v;
  v << 1, 2, 3, 0.1, -0.2, 0.3;
  const g2o::Isometry3 t = g2o::internal::fromVectorMQT(v);
  const Plane3D p = plane(0.3, -0.4, 0.5, -2), moved = t * p;
  const g2o::Vector3 point = p.distance() * p.normal();
  EXPECT_NEAR(moved.normal().dot(t * point) + moved.coeffs()[3], 0, 1e-14);
  EXPECT_LT((p.coeffs() - plane(0.6, -0.8, 1, -2).coeffs()).norm(), 1e-15);
}

TEST(Lines, HaveCartesianAndOrthonormalForms) {
  g2o::Vector6 cartesian;
  cartesian << 4, 3, -2, 2, 0, 0;
  const g2o::Line3D line = g2o::Line3D::fromCartesian(cartesian);
  g2o::Vector6 expected;
  expected << 0, -2, -3, 1, 0, 0;
  EXPECT_LT((line - expected).norm(), 1e-15);
  EXPECT_LT((line.toCartesian() - g2o::internal::normalizeCartesianLine(cartesian)).norm(), 1e-15);
  const g2o::OrthonormalLine3D parts = g2o::Line3D::toOrthonormal(line);
  EXPECT_LT((parts.U.transpose() * parts.U - g2o::Matrix3::Identity()).norm(), 1e-14);
  EXPECT_NEAR(parts.W(1, 0) / parts.W(0, 0), 1 / std::sqrt(13.0), 1e-14);
  EXPECT_LT((g2o::Line3D::fromOrthonormal(parts) - line).norm(), 1e-14);
  EXPECT_LT((g2o::Line3D(3 * line).normalized() - line).norm(), 1e-14);
}

TEST(Lines, KeepSixNumbersOfAFileThatAreNotOrthogonal) {
  const g2o::Vector6 numbers = (g2o::Vector6() << 1, 0.5, 0.2, 0.3, 0.1, 0.9).finished();
  std::istringstream in(
      "PARAMS_SE3OFFSET 0 0 0 0 0 0 0 1\n"
      "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\n"
      "VERTEX_LINE3D 1 1 0.5 0.2 0.3 0.1 0.9\n"
      "EDGE_SE3_LINE3D 0 1 0 1 0.5 0.2 0.3 0.1 0.9" +
      omega(4) + "\n");
  g2o::SparseOptimizer optimizer;
  ASSERT_TRUE(optimizer.load(in));
  auto* v = static_cast<g2o::VertexLine3D*>(optimizer.vertex(1));
  EXPECT_EQ(static_cast<const g2o::Vector6&>(v->estimate()), numbers);
  auto* e = static_cast<g2o::EdgeSE3Line3D*>(*optimizer.edges().begin());
  EXPECT_EQ(static_cast<const g2o::Vector6&>(e->measurement()), numbers);
  e->computeError();
  EXPECT_LT(e->error().norm(), 1e-12);
  v->setEstimate(g2o::Line3D::fromCartesian((g2o::Vector6() << 1, 2, 3, 0.3, -0.5, 0.7).finished()));
  std::stringstream rounded;  // with the default of six digits
  for (const double value : v->estimate()) rounded << value << ' ';
  EXPECT_TRUE(v->read(rounded));
  std::istringstream without_direction("1 2 3 0 0 0");
  EXPECT_FALSE(v->read(without_direction));
}

TEST(Lines, OplusUndoesOminus) {
  g2o::Vector6 from, to;
  from << 1, -2, 0.5, 1, 2, 3;
  to << 0.5, -2, 1, 1.2, 1.5, 3.5;
  const g2o::Line3D a = g2o::Line3D::fromCartesian(from), b = g2o::Line3D::fromCartesian(to);
  g2o::Line3D moved = a;
  moved.oplus(a.ominus(b));
  EXPECT_LT((moved - b).norm(), 1e-14);
}

TEST(Lines, AreMovedTogetherWithTheirPoints) {
  g2o::Vector6 v, cartesian;
  v << 1, 2, 3, 0.1, -0.2, 0.3;
  cartesian << 1, -2, 0.5, 1, 2, 3;
  const g2o::Isometry3 t = g2o::internal::fromVectorMQT(v);
  const g2o::Line3D moved = t * g2o::Line3D::fromCartesian(cartesian);
  EXPECT_LT((moved - g2o::Line3D::fromCartesian(g2o::internal::transformCartesianLine(t, cartesian))).norm(),
            1e-14);
}

TEST(Planes, AreEstimatedTogetherWithTheOffsetOfTheSensor) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  g2o::SparseOptimizer optimizer;
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmLevenberg(
      new g2o::BlockSolverX(new g2o::LinearSolverDense<g2o::BlockSolverX::PoseMatrixType>())));
  const auto vector = [&](double size) {
    g2o::Vector6 v;
    for (double& x : v) x = size * uniform(random);
    return v;
  };
  const g2o::Isometry3 truth = g2o::internal::fromVectorMQT(vector(0.2));
  auto* offset = new g2o::VertexSE3;
  offset->setId(0);
  offset->setEstimate(truth * g2o::internal::fromVectorMQT(vector(0.03)));
  optimizer.addVertex(offset);
  const std::vector<Plane3D> planes = {plane(1, 0.1, 0, 3), plane(0, 1, 0.2, 4), plane(0.1, -0.2, 1, 2)};
  for (size_t j = 0; j < planes.size(); ++j) {
    auto* v = new g2o::VertexPlane;
    v->setId(static_cast<int>(j) + 1);
    Plane3D estimate = planes[j];
    estimate.oplus(vector(0.03).head<3>());
    v->setEstimate(estimate);
    v->color = g2o::Vector3(1, 0, 0);
    optimizer.addVertex(v);
  }
  for (int i = 0; i < 12; ++i) {
    auto* pose = new g2o::VertexSE3;
    pose->setId(10 + i);
    pose->setEstimate(g2o::internal::fromVectorMQT(vector(0.5)));
    pose->setFixed(true);
    optimizer.addVertex(pose);
    for (size_t j = 0; j < planes.size(); ++j) {
      auto* e = new g2o::EdgeSE3PlaneSensorCalib;
      e->setVertex(0, pose);
      e->setVertex(1, optimizer.vertex(static_cast<int>(j) + 1));
      e->setVertex(2, offset);
      e->setMeasurement((pose->estimate() * truth).inverse() * planes[j]);
      ASSERT_TRUE(optimizer.addEdge(e));
    }
  }
  ASSERT_TRUE(optimizer.initializeOptimization());
  EXPECT_GT(optimizer.optimize(20), 0);
  EXPECT_LT((offset->estimate().matrix() - truth.matrix()).norm(), 1e-6);
  for (size_t j = 0; j < planes.size(); ++j) {
    const auto* v = static_cast<g2o::VertexPlane*>(optimizer.vertex(static_cast<int>(j) + 1));
    EXPECT_LT((v->estimate().coeffs() - planes[j].coeffs()).norm(), 1e-6);
  }
}

}  // namespace
