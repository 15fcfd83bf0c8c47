// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>

#include "g2o/core/block_solver.h"
#include "g2o/core/optimization_algorithm_levenberg.h"
#include "g2o/edge_checks.h"
#include "g2o/solvers/dense/linear_solver_dense.h"
#include "g2o/types/icp/types_icp.h"

G2O_USE_TYPE_GROUP(slam3d);
G2O_USE_TYPE_GROUP(icp);

namespace {

g2o::Isometry3 motion(double size) {
  g2o::Vector6 v;
  v << 1, -2, 0.5, 0.3, 0.1, -0.2;
  return g2o::internal::fromVectorMQT(size * v);
}

TEST(Icp, AllTypesHaveExactJacobiansAndAreWrittenAsTheyWereRead) {
  edge_checks::expect_laws_of_file(
      "VERTEX_SE3:QUAT 0 1 2 3 0.5 0.5 0.5 0.5\n"
      "VERTEX_SE3:QUAT 1 0.3 0.1 -0.2 0.1 -0.1 0.7 0.7\n"
      "EDGE_V_V_GICP 0 1 1 2 3 0 0.6 0.8 -1 0.5 2 0.6 0 0.8\n");
}

TEST(Icp, PrecisionAndCovarianceMatricesAreAlignedWithTheNormals) {
  g2o::EdgeGICP pair;
  pair.normal0 = g2o::Vector3(0, 0.6, 0.8);
  pair.normal1 = g2o::Vector3(0.6, 0, -0.8);
  const g2o::Vector3 across(1, 0, 0);
  EXPECT_LT((pair.prec0(0.01) * pair.normal0 - pair.normal0).norm(), 1e-14);
  EXPECT_LT((pair.prec0(0.01) * across - 0.01 * across).norm(), 1e-14);
  EXPECT_LT((pair.cov1(0.01) * pair.normal1 - 0.01 * pair.normal1).norm(), 1e-14);
  EXPECT_NEAR(pair.R0.determinant(), -1, 1e-14);
  EXPECT_LT((pair.R1 * pair.normal1 - g2o::Vector3::UnitZ()).norm(), 1e-14);
}

TEST(Icp, TheFrameOfANormalHasTheSameAxesAsInG2o) {
  g2o::EdgeGICP pair;
  pair.normal0 = g2o::Vector3(0.6, 0, 0.8);
  pair.makeRot0();
  g2o::Matrix3 expected;
  expected << -0.8, 0, 0.6, 0, 1, 0, 0.6, 0, 0.8;  // rows: n × y, y, n
  EXPECT_LT((pair.R0 - expected).norm(), 1e-15);
  pair.normal1 = g2o::Vector3(0, 0, 2);
  pair.makeRot1();
  expected << -2, 0, 0, 0, 1, 0, 0, 0, 2;  // the normal is not normalized
  EXPECT_EQ(pair.R1, expected);
}

TEST(Icp, AUnitNormalInAnyDirectionHasAnOrthogonalFrame) {
  for (const g2o::Vector3& axis : {g2o::Vector3(1, 0, 0), g2o::Vector3(0, 1, 0), g2o::Vector3(0, 0, 1)}) {
    for (const double tilt : {0., 1e-12, 1e-9, 1e-6, 1e-3, 1e-2}) {
      for (const double sign : {1., -1.}) {
        g2o::EdgeGICP pair;
        pair.normal0 = pair.normal1 = sign * (axis + tilt * g2o::Vector3(0.5, -0.25, 1)).normalized();
        SCOPED_TRACE(pair.normal0.transpose());
        pair.makeRot0();
        EXPECT_LT((pair.R0 * pair.R0.transpose() - g2o::Matrix3::Identity()).norm(), 1e-12);
        EXPECT_NEAR(pair.R0.determinant(), -1, 1e-12);
        const g2o::Matrix3 along = pair.normal0 * pair.normal0.transpose();
        const g2o::Matrix3 across = g2o::Matrix3::Identity() - along;
        EXPECT_LT((pair.prec1(0.01) - along - 0.01 * across).norm(), 1e-12);
        EXPECT_LT((pair.cov1(0.01) - 0.01 * along - across).norm(), 1e-12);
      }
    }
  }
}

TEST(Icp, PlanesThatAreLevelInACameraFrameAreAlignedWithEachOther) {
  g2o::SparseOptimizer optimizer;
  std::istringstream in(
      "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\nVERTEX_SE3:QUAT 1 0 0 0 0 0 0 1\n"
      "EDGE_V_V_GICP 0 1 1 2 3 0 1 0 2 4 6 0 1 0\n");
  ASSERT_TRUE(optimizer.load(in));
  auto* e = static_cast<g2o::Edge_V_V_GICP*>(*optimizer.edges().begin());
  EXPECT_LT((e->information() - g2o::Matrix3(g2o::Vector3(0.01, 1, 0.01).asDiagonal())).norm(), 1e-15)
      << "Ω of the file";
  g2o::EdgeGICP pair = e->measurement();
  e->cov0 = pair.cov0(0.01);
  e->cov1 = pair.cov1(0.01);
  e->pl_pl = true;
  e->computeError();
  EXPECT_LT((e->information() - g2o::Matrix3(g2o::Vector3(0.5, 50, 0.5).asDiagonal())).norm(), 1e-12);
  EXPECT_NEAR(e->chi2(), 0.5 * 1 + 50 * 4 + 0.5 * 9, 1e-10);
}

TEST(Icp, AZeroNormalGivesAFiniteInformationMatrix) {
  g2o::EdgeGICP pair;
  pair.normal0.setZero();
  EXPECT_TRUE(pair.prec0(0.01).allFinite());
  g2o::SparseOptimizer optimizer;
  std::istringstream in(
      "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\nVERTEX_SE3:QUAT 1 0 0 0 0 0 0 1\n"
      "EDGE_V_V_GICP 0 1 1 2 3 0 0 0 1 2 3 0 0 0\n");
  ASSERT_TRUE(optimizer.load(in));
  const auto* e = static_cast<const g2o::Edge_V_V_GICP*>(*optimizer.edges().begin());
  EXPECT_TRUE(e->information().allFinite());
}

TEST(Icp, AnEdgeCanBeConstructedAsACopyOfAnotherEdge) {
  g2o::SparseOptimizer optimizer;
  std::istringstream in(
      "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\nVERTEX_SE3:QUAT 1 0 0 0 0 0 0 1\n"
      "EDGE_V_V_GICP 0 1 1 2 3 0 0.6 0.8 1 2 4 0 0 1\n");
  ASSERT_TRUE(optimizer.load(in));
  const auto* e = static_cast<const g2o::Edge_V_V_GICP*>(*optimizer.edges().begin());
  auto* second = new g2o::Edge_V_V_GICP(e);
  EXPECT_EQ(second->vertex(1), optimizer.vertex(1));
  EXPECT_EQ(second->measurement().normal0, e->measurement().normal0);
  second->computeError();
  EXPECT_LT((second->error() - g2o::Vector3(0, 0, 1)).norm(), 1e-15);
  EXPECT_TRUE(optimizer.addEdge(second));
}

TEST(Icp, TheIcpHeaderIncludesTheTypesOfBundleAdjustment) {
  const g2o::SE3Quat pose(g2o::Quaternion::Identity(), g2o::Vector3(1, 2, 3));
  g2o::VertexCam camera;
  camera.setEstimate(pose);  // converts to an SBACam, as in g2o
  EXPECT_EQ(camera.estimate().translation(), g2o::Vector3(1, 2, 3));
}

TEST(Icp, PlaneToPlaneInformationMatricesCombineBothCovariances) {
  g2o::SparseOptimizer optimizer;
  for (int id : {0, 1}) {
    auto* v = new g2o::VertexSE3;
    v->setId(id);
    v->setEstimate(motion(id));
    optimizer.addVertex(v);
  }
  auto* e = new g2o::Edge_V_V_GICP;
  e->setVertex(0, optimizer.vertex(0));
  e->setVertex(1, optimizer.vertex(1));
  g2o::EdgeGICP pair;
  e->cov0 = pair.cov0(0.001);
  e->cov1 = pair.cov1(0.001);
  e->pl_pl = true;
  e->setMeasurement(pair);
  ASSERT_TRUE(optimizer.addEdge(e));
  e->computeError();
  const g2o::Matrix3 R = motion(1).linear();
  EXPECT_LT((e->information() * (e->cov0 + R * e->cov1 * R.transpose()) - g2o::Matrix3::Identity()).norm(),
            1e-12);
  EXPECT_LT((e->error() - motion(1).translation()).norm(), 1e-14);
}

TEST(Icp, OptimizationAlignsTwoScans) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  g2o::SparseOptimizer optimizer;
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmLevenberg(
      new g2o::BlockSolverX(new g2o::LinearSolverDense<g2o::BlockSolverX::PoseMatrixType>())));
  for (int id : {0, 1}) {
    auto* v = new g2o::VertexSE3;
    v->setId(id);
    v->setEstimate(motion(0.9 * id));
    v->setFixed(id == 0);
    optimizer.addVertex(v);
  }
  for (int i = 0; i < 100; ++i) {
    g2o::EdgeGICP pair;
    pair.pos0 = 10 * g2o::Vector3(uniform(random), uniform(random), uniform(random));
    pair.pos1 = motion(1).inverse() * pair.pos0;
    pair.normal0 = g2o::Vector3(uniform(random), uniform(random), uniform(random)).normalized();
    auto* e = new g2o::Edge_V_V_GICP;
    e->setVertex(0, optimizer.vertex(0));
    e->setVertex(1, optimizer.vertex(1));
    e->setMeasurement(pair);
    e->setInformation(pair.prec0(0.01));
    ASSERT_TRUE(optimizer.addEdge(e));
  }
  ASSERT_TRUE(optimizer.initializeOptimization());
  EXPECT_GT(optimizer.optimize(10), 0);
  const auto* v = static_cast<g2o::VertexSE3*>(optimizer.vertex(1));
  EXPECT_LT((v->estimate().matrix() - motion(1).matrix()).norm(), 1e-7);
}

TEST(Icp, StereoCamerasShareOneCameraMatrix) {
  g2o::VertexSCam::setKcam(100, 200, 10, 20, 0.08);
  g2o::SparseOptimizer optimizer;
  auto* camera = new g2o::VertexSCam;
  camera->setId(0);
  g2o::Isometry3 pose = g2o::Isometry3::Identity();
  pose.translation().z() = -1;
  camera->setEstimate(pose);
  camera->setAll();
  auto* point = new g2o::VertexPointXYZ;
  point->setId(1);
  point->setEstimate({1, 2, 3});
  optimizer.addVertex(camera);
  optimizer.addVertex(point);
  auto* e = new g2o::Edge_XYZ_VSC;
  e->setVertex(0, point);
  e->setVertex(1, camera);
  e->setMeasurement({34, 122, 33});
  ASSERT_TRUE(optimizer.addEdge(e));
  e->computeError();
  EXPECT_LT((e->error() - g2o::Vector3(1, -2, 0)).norm(), 1e-12);
  EXPECT_EQ(g2o::VertexSCam::Kcam(1, 1), 200);
  EXPECT_EQ(g2o::VertexSCam::baseline, 0.08);
  const g2o::Vector3 image = camera->w2i * g2o::Vector4(1, 2, 3, 1);
  EXPECT_NEAR(image[0] / image[2], 35, 1e-12);
  camera->setEstimate(motion(0.1));
  edge_checks::expect_exact_jacobians(*e);
}

TEST(Icp, RotationDerivativesOfAStereoCameraAreWithRespectToItsQuaternion) {
  g2o::VertexSCam camera;
  camera.setEstimate(motion(1));
  camera.setAll();
  const g2o::Matrix3 derivatives[] = {camera.dRdx, camera.dRdy, camera.dRdz};
  for (int axis = 0; axis < 3; ++axis) {
    g2o::Matrix3 rotations[2];
    for (int sign : {-1, 1}) {
      g2o::VertexSCam moved;
      moved.setEstimate(motion(1));
      double step[6] = {};
      step[3 + axis] = sign * 1e-6;
      moved.oplus(step);
      moved.setTransform();
      rotations[sign > 0 ? 1 : 0] = moved.w2n.leftCols<3>();
    }
    EXPECT_LT((derivatives[axis] - (rotations[1] - rotations[0]) / 2e-6).norm(), 1e-8);
  }
}

}  // namespace
