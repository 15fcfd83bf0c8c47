// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>

#include "g2o/core/base_unary_edge.h"
#include "g2o/core/block_solver.h"
#include "g2o/core/optimization_algorithm_gauss_newton.h"
#include "g2o/core/optimization_algorithm_levenberg.h"
#include "g2o/edge_checks.h"
#include "g2o/solvers/dense/linear_solver_dense.h"
#include "g2o/types/types_seven_dof_expmap.h"
#include "g2o/types/types_six_dof_expmap.h"

G2O_USE_TYPE_GROUP(slam3d);
G2O_USE_TYPE_GROUP(sba);
G2O_USE_TYPE_GROUP(expmap);
G2O_USE_TYPE_GROUP(sim3);

namespace {

using edge_checks::omega;

TEST(Sba, CameraTypesHaveExactJacobiansAndAreWrittenAsTheyWereRead) {
  edge_checks::expect_laws_of_file(
      "VERTEX_CAM 0 0.1 0.2 -0.3 0.1 -0.1 0.7 0.7 500 510 320 240 0.12\n"
      "VERTEX_CAM 1 1.1 0.1 0.3 0.5 -0.5 0.5 0.5 400 410 310 230 0.2\n"
      "VERTEX_XYZ 2 0.5 -0.4 3\n"
      "VERTEX_TRACKXYZ 3 -0.3 0.4 4\n"
      "EDGE_PROJECT_P2MC 2 0 300 200" +
      omega(2) +
      "\n"
      "EDGE_PROJECT_P2SC 3 0 290 210 250" +
      omega(3) +
      "\n"
      "EDGE_PROJECT_P2MC 3 1 300 200" +
      omega(2) +
      "\n"
      "EDGE_CAM 0 1 0.3 0.2 0.1 0.1 -0.1 0.7 0.7" +
      omega(6) +
      "\n"
      "EDGE_SCALE 0 1 2.5" +
      omega(1) + "\n");
}

TEST(Sba, TypesWithTheExponentialMapHaveExactJacobiansAndAreWrittenAsTheyWereRead) {
  edge_checks::expect_laws_of_file(
      "PARAMS_CAMERAPARAMETERS 0 450 300 200 0.1\n"
      "VERTEX_SE3:EXPMAP 0 0.1 0.2 -0.3 0.1 -0.1 0.7 0.7\n"
      "VERTEX_SE3:EXPMAP 1 1.1 0.1 0.3 0.5 -0.5 0.5 0.5\n"
      "VERTEX_XYZ 2 0.5 -0.4 3\n"
      "VERTEX_TRACKXYZ 3 -0.3 0.4 4\n"
      "EDGE_SE3:EXPMAP 0 1 0.3 0.2 0.1 0.5 0.5 -0.5 0.5" +
      omega(6) +
      "\n"
      "EDGE_PROJECT_XYZ2UV:EXPMAP 2 0 0 300 200" +
      omega(2) +
      "\n"
      "EDGE_PROJECT_XYZ2UVU:EXPMAP 3 1 0 300 200 250" +
      omega(3) +
      "\n"
      "EDGE_SE3_PROJECT_XYZ:EXPMAP 2 0 300 200" +
      omega(2) +
      " 500 510 320 240\n"
      "EDGE_SE3_PROJECT_XYZONLYPOSE:EXPMAP 0 300 200" +
      omega(2) +
      " 0.1 0.2 3 500 510 320 240\n"
      "EDGE_STEREO_SE3_PROJECT_XYZ:EXPMAP 3 1 300 200 250" +
      omega(3) +
      " 500 510 320 240 50\n"
      "EDGE_STEREO_SE3_PROJECT_XYZONLYPOSE:EXPMAP 0 300 200 250" +
      omega(3) + " 0.1 0.2 3 500 510 320 240 50\n");
}

TEST(Sba, SimilarityTypesHaveExactJacobiansAndAreWrittenAsTheyWereRead) {
  edge_checks::expect_laws_of_file(
      "VERTEX_SIM3:EXPMAP 0 0.3 -0.2 0.1 0.4 0.5 -0.2 0.1 500 510 320 240 400 410 310 230\n"
      "VERTEX_SIM3:EXPMAP 1 -0.3 0.4 0.2 0.1 -0.5 0.3 -0.2 500 510 320 240 400 410 310 230\n"
      "VERTEX_XYZ 2 0.5 -0.4 3\n"
      "EDGE_SIM3:EXPMAP 0 1 0.1 0.2 -0.1 0.3 0.1 -0.2 0.05" +
      omega(7) +
      "\n"
      "EDGE_PROJECT_SIM3_XYZ:EXPMAP 2 0 300 200" +
      omega(2) +
      "\n"
      "EDGE_PROJECT_INVERSE_SIM3_XYZ:EXPMAP 2 0 300 200" +
      omega(2) + "\n");
}

TEST(Sba, JacobiansAreExactIfTheScaleIsFixed) {
  g2o::SparseOptimizer optimizer;
  std::istringstream in(
      "VERTEX_SIM3:EXPMAP 0 0.3 -0.2 0.1 0.4 0.5 -0.2 0.1 500 510 320 240\n"
      "VERTEX_SIM3:EXPMAP 1 -0.3 0.4 0.2 0.1 -0.5 0.3 -0.2 500 510 320 240\n"
      "VERTEX_XYZ 2 0.5 -0.4 3\n"
      "EDGE_SIM3:EXPMAP 0 1 0.1 0.2 -0.1 0.3 0.1 -0.2 0.05" +
      omega(7) +
      "\n"
      "EDGE_PROJECT_SIM3_XYZ:EXPMAP 2 0 300 200" +
      omega(2) +
      "\n"
      "EDGE_PROJECT_INVERSE_SIM3_XYZ:EXPMAP 2 0 3 2" +
      omega(2) + "\n");
  ASSERT_TRUE(optimizer.load(in));
  for (int id : {0, 1}) static_cast<g2o::VertexSim3Expmap*>(optimizer.vertex(id))->_fix_scale = true;
  for (g2o::HyperGraph::Edge* e : optimizer.edges())
    edge_checks::expect_exact_jacobians(*static_cast<g2o::OptimizableGraph::Edge*>(e));
}

TEST(Sba, ASimilarityIgnoresAStepThatOverflowsAndCanStillBeSaved) {
  g2o::VertexSim3Expmap v;
  double overflow[] = {0, 0, 0, 0, 0, 0, 1000}, underflow[] = {0, 0, 0, 0, 0, 0, -1000};
  for (double* step : {overflow, underflow}) {
    v.oplus(step);
    EXPECT_EQ(v.estimate().scale(), 1);
    std::ostringstream out;
    EXPECT_TRUE(v.write(out));
    std::istringstream in(out.str());
    g2o::VertexSim3Expmap again;
    EXPECT_TRUE(again.read(in));
  }
  std::istringstream huge("0 0 0 0 0 0 800 1 1 0 0");
  EXPECT_FALSE(v.read(huge)) << "the scale would overflow";
  g2o::EdgeSim3 e;
  std::istringstream huge_measurement("0 0 0 0 0 0 800" + omega(7));
  EXPECT_FALSE(e.read(huge_measurement));
}

/// A measurement of the logarithm of a scale. It may be so large that the scale overflows.
class ScaleEdge : public g2o::BaseUnaryEdge<1, double, g2o::VertexSim3Expmap> {
 public:
  void computeError() override { _error[0] = std::log(vertexXn<0>()->estimate().scale()) - _measurement; }
  bool read(std::istream&) override { return false; }
  bool write(std::ostream&) const override { return false; }
};

TEST(Sba, AnAlgorithmDoesNotTakeAStepThatASimilarityRefuses) {
  for (const bool is_levenberg : {false, true}) {
    g2o::SparseOptimizer optimizer;
    auto solver = std::make_unique<g2o::BlockSolverX>(
        std::make_unique<g2o::LinearSolverDense<g2o::BlockSolverX::PoseMatrixType>>());
    if (is_levenberg) {
      optimizer.setAlgorithm(new g2o::OptimizationAlgorithmLevenberg(std::move(solver)));
    } else {
      optimizer.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(std::move(solver)));
    }
    auto* v = new g2o::VertexSim3Expmap;
    v->setId(0);
    ASSERT_TRUE(optimizer.addVertex(v));
    auto* e = new ScaleEdge;
    e->setVertex(0, v);
    e->setMeasurement(1e4);
    e->setInformation(Eigen::Matrix<double, 1, 1>::Identity());
    ASSERT_TRUE(optimizer.addEdge(e));
    auto* origin = new g2o::VertexSim3Expmap;
    origin->setId(1);
    origin->setFixed(true);
    ASSERT_TRUE(optimizer.addVertex(origin));
    auto* prior = new g2o::EdgeSim3;
    prior->setVertex(0, origin);
    prior->setVertex(1, v);
    prior->setInformation(1e-6 * g2o::Matrix7::Identity());
    ASSERT_TRUE(optimizer.addEdge(prior));
    ASSERT_TRUE(optimizer.initializeOptimization());
    const int done = optimizer.optimize(10);
    EXPECT_TRUE(is_levenberg || done == 0) << "Gauss-Newton must stop, because it has no other step";
    std::ostringstream out;
    EXPECT_TRUE(optimizer.saveVertex(out, v));
    EXPECT_EQ(out.str().find("nan"), std::string::npos) << out.str();
    EXPECT_EQ(out.str().find("inf"), std::string::npos) << out.str();
  }
}

/// A client's edge on VertexSBAPointXYZ.
class PointPrior : public g2o::BaseUnaryEdge<3, g2o::Vector3, g2o::VertexSBAPointXYZ> {
 public:
  void computeError() override {
    _error = static_cast<const g2o::VertexSBAPointXYZ*>(_vertices[0])->estimate() - _measurement;
  }
  bool read(std::istream&) override { return false; }
  bool write(std::ostream&) const override { return false; }
};

TEST(Sba, AnEdgeOfAClientOnVertexSBAPointXYZAcceptsAVertexPointXYZ) {
  g2o::SparseOptimizer optimizer;
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(std::make_unique<g2o::BlockSolverX>(
      std::make_unique<g2o::LinearSolverDense<g2o::BlockSolverX::PoseMatrixType>>())));
  auto* point = new g2o::VertexPointXYZ;
  point->setId(0);
  ASSERT_TRUE(optimizer.addVertex(point));
  auto* prior = new PointPrior;
  prior->setVertex(0, point);
  prior->setMeasurement({1, 2, 3});
  prior->setInformation(g2o::Matrix3::Identity());
  ASSERT_TRUE(optimizer.addEdge(prior));
  ASSERT_TRUE(optimizer.initializeOptimization());
  EXPECT_EQ(optimizer.optimize(5), 5);
  EXPECT_LT((point->estimate() - g2o::Vector3(1, 2, 3)).norm(), 1e-9);
}

TEST(Sba, TheJacobiansOfAnInverseDepthPointAreExact) {
  g2o::SparseOptimizer optimizer;
  std::istringstream in(
      "PARAMS_CAMERAPARAMETERS 0 450 300 200 0.1\n"
      "VERTEX_SE3:EXPMAP 0 0.1 0.2 -0.3 0.1 -0.1 0.7 0.7\n"
      "VERTEX_SE3:EXPMAP 1 1.1 0.1 0.3 0.5 -0.5 0.5 0.5\n"
      "VERTEX_XYZ 2 0.1 -0.2 0.3\n");
  ASSERT_TRUE(optimizer.load(in));
  auto* e = new g2o::EdgeProjectPSI2UV;
  e->resize(3);
  e->setVertex(0, optimizer.vertex(2));
  e->setVertex(1, optimizer.vertex(0));
  e->setVertex(2, optimizer.vertex(1));
  e->setParameterId(0, 0);
  e->setMeasurement({300, 200});
  ASSERT_TRUE(optimizer.addEdge(e));
  edge_checks::expect_exact_jacobians(*e);
  // The expected projection: the point (0.1, −0.2, 1) / 0.3 in the frame of the anchor, which is vertex 1, is
  // moved to the frame of vertex 0.
  const auto pose = [&](int id) {
    return static_cast<g2o::VertexSE3Expmap*>(optimizer.vertex(id))->estimate();
  };
  const g2o::Vector3 p = pose(0) * (pose(1).inverse() * g2o::Vector3(1. / 3, -2. / 3, 1 / 0.3));
  e->computeError();
  EXPECT_NEAR(e->error()[0], 300 - (450 * p.x() / p.z() + 300), 1e-9);
  EXPECT_NEAR(e->error()[1], 200 - (450 * p.y() / p.z() + 200), 1e-9);
}

TEST(Sba, AnInverseDepthPointMayBeAtInfinity) {
  g2o::SparseOptimizer optimizer;
  std::istringstream in(
      "PARAMS_CAMERAPARAMETERS 0 450 300 200 0.1\n"
      "VERTEX_SE3:EXPMAP 0 0 0 0 0 0 0 1\n"
      "VERTEX_SE3:EXPMAP 1 5 6 7 0 0 0 1\n"
      "VERTEX_XYZ 2 0.1 -0.2 0\n");
  ASSERT_TRUE(optimizer.load(in));
  auto* e = new g2o::EdgeProjectPSI2UV;
  e->resize(3);
  for (int n = 0; n < 3; ++n) e->setVertex(static_cast<std::size_t>(n), optimizer.vertex((n + 2) % 3));
  e->setParameterId(0, 0);
  ASSERT_TRUE(optimizer.addEdge(e));
  e->computeError();
  EXPECT_LT((e->error() + g2o::Vector2(450 * 0.1 + 300, 450 * -0.2 + 200)).norm(), 1e-12);
  edge_checks::expect_exact_jacobians(*e);
}

TEST(Sba, AClientMayGiveTheCameraMatrixASkew) {
  g2o::SparseOptimizer optimizer;
  std::istringstream in(
      "VERTEX_CAM 0 0 0 0 0 0 0 1 100 200 10 20 0.08\n"
      "VERTEX_XYZ 1 1 2 4\n"
      "EDGE_PROJECT_P2MC 1 0 0 0" +
      omega(2) +
      "\n"
      "EDGE_PROJECT_P2SC 1 0 0 0 0" +
      omega(3) + "\n");
  ASSERT_TRUE(optimizer.load(in));
  auto* v = static_cast<g2o::VertexCam*>(optimizer.vertex(0));
  g2o::SBACam cam = v->estimate();
  cam.Kcam(0, 1) = 8;  // u increases by 8 · 2/4
  v->setEstimate(cam);
  for (g2o::HyperGraph::Edge* each : optimizer.edges()) {
    auto* e = static_cast<g2o::OptimizableGraph::Edge*>(each);
    e->computeError();
    EXPECT_NEAR(e->errorData()[0], 39, 1e-12);
    EXPECT_NEAR(e->errorData()[1], 120, 1e-12);
    edge_checks::expect_exact_jacobians(*e);
  }
}

TEST(Sba, FilesStoreTheInversesOfEstimatesAndMeasurements) {
  g2o::VertexSE3Expmap v;
  std::istringstream in("1 2 3 0 0 0 1");
  ASSERT_TRUE(v.read(in));
  EXPECT_LT((v.estimate().translation() - g2o::Vector3(-1, -2, -3)).norm(), 1e-15);
  g2o::EdgeSE3Expmap e;
  std::istringstream measurement("1 0 0 0 0 0 1" + omega(6));
  ASSERT_TRUE(e.read(measurement));
  g2o::VertexSE3Expmap a, b;
  e.setVertex(0, &a);
  e.setVertex(1, &b);
  e.computeError();
  g2o::Vector6 expected;
  expected << 0, 0, 0, -1, 0, 0;
  EXPECT_LT((e.error() - expected).norm(), 1e-15);
  g2o::VertexSim3Expmap s;
  std::istringstream similarity("0 0 0 0 0 0 0.5 1 1 0 0");
  ASSERT_TRUE(s.read(similarity));
  EXPECT_NEAR(s.estimate().scale(), std::exp(-0.5), 1e-15);
}

TEST(Sba, ErrorsFollowTheSignConventionsOfTheFileFormat) {
  const std::vector<double> mono = {1, -2}, stereo = {1, -2, 0};
  edge_checks::expect_errors(
      "VERTEX_CAM 0 0 0 0 0 0 0 1 100 200 10 20 0.08\n"
      "VERTEX_CAM 1 1 0 0 0 0 0 1 100 200 10 20 0.08\n"
      "VERTEX_XYZ 2 1 2 4\n"
      "EDGE_PROJECT_P2MC 2 0 34 122" +
          omega(2) +
          "\n"
          "EDGE_PROJECT_P2SC 2 0 34 122 33" +
          omega(3) +
          "\n"
          "EDGE_CAM 0 1 0 0 0 0 0 0 1" +
          omega(6) +
          "\n"
          "EDGE_SCALE 0 1 3" +
          omega(1) + "\n",
      {{"EDGE_PROJECT_P2MC", mono},
       {"EDGE_PROJECT_P2SC", stereo},
       {"EDGE_CAM", {1, 0, 0, 0, 0, 0}},
       {"EDGE_SCALE", {2}}});
  edge_checks::expect_errors(
      "PARAMS_CAMERAPARAMETERS 0 100 10 20 0.08\n"
      "VERTEX_SE3:EXPMAP 0 0 0 0 0 0 0 1\n"
      "VERTEX_XYZ 2 1 2 4\n"
      "EDGE_PROJECT_XYZ2UV:EXPMAP 2 0 0 36 68" +
          omega(2) +
          "\n"
          "EDGE_PROJECT_XYZ2UVU:EXPMAP 2 0 0 36 68 33" +
          omega(3) +
          "\n"
          "EDGE_SE3_PROJECT_XYZ:EXPMAP 2 0 36 118" +
          omega(2) +
          " 100 200 10 20\n"
          "EDGE_SE3_PROJECT_XYZONLYPOSE:EXPMAP 0 36 118" +
          omega(2) +
          " 1 2 4 100 200 10 20\n"
          "EDGE_STEREO_SE3_PROJECT_XYZ:EXPMAP 2 0 36 118 33" +
          omega(3) +
          " 100 200 10 20 8\n"
          "EDGE_STEREO_SE3_PROJECT_XYZONLYPOSE:EXPMAP 0 36 118 33" +
          omega(3) + " 1 2 4 100 200 10 20 8\n",
      {{"EDGE_PROJECT_XYZ2UV:EXPMAP", mono},
       {"EDGE_PROJECT_XYZ2UVU:EXPMAP", stereo},
       {"EDGE_SE3_PROJECT_XYZ:EXPMAP", mono},
       {"EDGE_SE3_PROJECT_XYZONLYPOSE:EXPMAP", mono},
       {"EDGE_STEREO_SE3_PROJECT_XYZ:EXPMAP", stereo},
       {"EDGE_STEREO_SE3_PROJECT_XYZONLYPOSE:EXPMAP", stereo}});
  edge_checks::expect_errors(
      "VERTEX_SIM3:EXPMAP 0 0 0 0 0 0 0 0 100 200 10 20 50 100 5 10\n"
      "VERTEX_SIM3:EXPMAP 1 0 0 0 0 0 0 0 100 200 10 20\n"
      "VERTEX_XYZ 2 1 2 4\n"
      "EDGE_SIM3:EXPMAP 0 1 0 0 0 0 0 0 0.5" +
          omega(7) +
          "\n"
          "EDGE_PROJECT_SIM3_XYZ:EXPMAP 2 0 36 118" +
          omega(2) +
          "\n"
          "EDGE_PROJECT_INVERSE_SIM3_XYZ:EXPMAP 2 0 18.5 58" +
          omega(2) + "\n",
      {{"EDGE_SIM3:EXPMAP", {0, 0, 0, 0, 0, 0, -0.5}},
       {"EDGE_PROJECT_SIM3_XYZ:EXPMAP", mono},
       {"EDGE_PROJECT_INVERSE_SIM3_XYZ:EXPMAP", mono}});
}

TEST(Sba, EdgesProjectPointsWithThePinholeModel) {
  g2o::VertexSBAPointXYZ point;
  point.setEstimate({1, 2, 3});
  g2o::VertexSE3Expmap pose;
  pose.setEstimate(g2o::SE3Quat(g2o::Quaternion::Identity(), {0, 0, 1}));
  g2o::EdgeStereoSE3ProjectXYZ e;
  e.setVertex(0, &point);
  e.setVertex(1, &pose);
  e.fx = 100;
  e.fy = 200;
  e.cx = 10;
  e.cy = 20;
  e.bf = 8;
  e.setMeasurement({36, 118, 33});
  e.computeError();
  EXPECT_LT((e.error() - g2o::Vector3(1, -2, 0)).norm(), 1e-12);
  EXPECT_TRUE(e.isDepthPositive());
  EXPECT_LT((e.cam_project({1, 2, 4}, 16) - g2o::Vector3(35, 120, 31)).norm(), 1e-12);
  point.setEstimate({1, 2, -3});
  EXPECT_FALSE(e.isDepthPositive());
  const g2o::CameraParameters camera(100, {10, 20}, 0.08);
  EXPECT_LT((camera.stereocam_uvu_map({1, 2, 4}) - g2o::Vector3(35, 70, 33)).norm(), 1e-12);
}

TEST(Sba, AStepOfACameraTranslatesInTheWorldFrameAndRotatesInTheBodyFrame) {
  g2o::VertexCam v;
  const g2o::Quaternion quarter(std::sqrt(0.5), 0, 0, std::sqrt(0.5));
  g2o::SBACam cam(quarter, {1, 0, 0});
  cam.setKcam(300, 300, 320, 240, 0.1);
  v.setEstimate(cam);
  const double step[] = {0.5, 0, 0, 0.1, 0, 0};
  v.oplus(step);
  EXPECT_LT((v.estimate().translation() - g2o::Vector3(1.5, 0, 0)).norm(), 1e-15);
  const g2o::Quaternion turned = quarter * g2o::Quaternion(std::sqrt(0.99), 0.1, 0, 0);
  EXPECT_LT((v.estimate().rotation().coeffs() - turned.coeffs()).norm(), 1e-15);
  EXPECT_LT((v.estimate().w2n * g2o::Vector4(1.5, 0, 0, 1)).norm(), 1e-15);
  EXPECT_NEAR(v.estimate().Kcam(0, 2), 320, 0);
}

TEST(Sba, ACameraHasADefaultMatrixIfTheFileDoesNotContainOne) {
  g2o::VertexCam v;
  std::istringstream without("1 2 3 0 0 0 1"), half("1 2 3 0 0 0 1 500 500");
  ASSERT_TRUE(v.read(without));
  EXPECT_FALSE(without.fail());
  EXPECT_EQ(v.estimate().Kcam(0, 0), 300);
  EXPECT_EQ(v.estimate().baseline, 0.1);
  EXPECT_FALSE(v.read(half));
}

TEST(Sim3, TheLogarithmIsTheInverseOfTheExponential) {
  g2o::Vector7 v;
  v << 0.3, -0.2, 0.5, 1, -2, 3, 0.4;
  for (const double size : {0., 1e-9, 1e-3, 1., 4.}) {
    EXPECT_LT((g2o::Sim3(g2o::Vector7(size * v)).log() - size * v).norm(), 1e-11 * (1 + size));
  }
}

TEST(Sim3, AProductMapsPointsAsTheCompositionOfItsFactors) {
  g2o::Vector7 v;
  v << 0.3, -0.2, 0.5, 1, -2, 3, 0.4;
  const g2o::Sim3 a(v), b(g2o::Vector7(-0.7 * v.reverse()));
  const g2o::Vector3 p(1, 2, 3);
  EXPECT_LT(((a * b).map(p) - a.map(b.map(p))).norm(), 1e-13);
  EXPECT_LT((a.inverse().map(a.map(p)) - p).norm(), 1e-13);
  EXPECT_EQ(a[7], a.scale());
  EXPECT_EQ(a[3], a.rotation().w());
  EXPECT_EQ(a[4], a.translation().x());
}

}  // namespace
