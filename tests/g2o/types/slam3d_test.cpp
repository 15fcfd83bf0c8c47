// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <memory>

#include "g2o/edge_checks.h"
#include "g2o/types/edge_pointxyz.h"
#include "g2o/types/slam3d/isometry3d_gradients.h"
#include "g2o/types/slam3d/types_slam3d.h"
#include "g2o/types/vertex_pointxyz.h"

G2O_USE_TYPE_GROUP(slam3d);

namespace {

using edge_checks::omega;

TEST(Slam3d, AllTypesHaveExactJacobiansAndAreWrittenAsTheyWereRead) {
  edge_checks::expect_laws_of_file(
      "PARAMS_SE3OFFSET 0 0.1 0.2 0.3 0.5 -0.5 0.5 0.5\n"
      "PARAMS_SE3OFFSET 1 -0.3 0.1 1.2 0.1 -0.1 0.7 0.7\n"
      "PARAMS_CAMERACALIB 2 0.1 -0.2 0.3 0.1 -0.1 0.7 0.7 500 510 320 240\n"
      "PARAMS_STEREOCAMERACALIB 3 0.1 -0.2 0.3 0.5 0.5 -0.5 0.5 400 410 310 230 0.12\n"
      "VERTEX_SE3:QUAT 0 1 2 3 0.5 0.5 0.5 0.5\n"
      "VERTEX_SE3:QUAT 1 3 1 -0.7 0.1 -0.1 0.7 0.7\n"
      "VERTEX_TRACKXYZ 2 4 5 6\n"
      "VERTEX_TRACKXYZ 3 -1 2 -2\n"
      "EDGE_SE3:QUAT 0 1 2 0.3 -1 0.1 -0.1 0.7 0.7" +
      omega(6) +
      "\n"
      "EDGE_SE3_TRACKXYZ 0 2 1 3 2 1" +
      omega(3) +
      "\n"
      "EDGE_SE3_PRIOR 1 0 3.1 0.9 -0.6 0.5 -0.5 0.5 0.5" +
      omega(6) +
      "\n"
      "EDGE_SE3_XYZ_PRIOR 1 0 3.1 0.9 -0.6" +
      omega(3) +
      "\n"
      "EDGE_SE3_OFFSET 0 1 0 1 2 0.3 -1 0.1 -0.1 0.7 0.7" +
      omega(6) +
      "\n"
      "EDGE_POINTXYZ 2 3 -5.1 -3.1 -8" +
      omega(3) +
      "\n"
      "EDGE_POINTXYZ_PRIOR 3 -1.1 2.1 -2.2" +
      omega(3) +
      "\n"
      "EDGE_SE3_LOTSOF_XYZ 1 3 2 || 2 3 2 1 -2 1 2" +
      omega(6) +
      "\n"
      "EDGE_PROJECT_DEPTH 0 2 2 300 200 5" +
      omega(3) +
      "\n"
      "EDGE_PROJECT_DISPARITY 1 3 3 300 200 0.2" +
      omega(3) +
      "\n"
      "EDGE_PROJECT_DISPARITY 0 2 2 300 200 0.2" +
      omega(3) + "\n");
}

TEST(Slam3d, DepthAndDisparityEdgesProjectWithThePinholeModel) {
  edge_checks::expect_errors(
      "PARAMS_CAMERACALIB 0 0 0 -1 0 0 0 1 100 200 10 20\n"
      "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\n"
      "VERTEX_TRACKXYZ 1 1 2 3\n"
      "EDGE_PROJECT_DEPTH 0 1 0 34 122 3.5" +
          omega(3) +
          "\n"
          "EDGE_PROJECT_DISPARITY 0 1 0 34 122 0.5" +
          omega(3) + "\n",
      {{"EDGE_PROJECT_DEPTH", {1, -2, 0.5}}, {"EDGE_PROJECT_DISPARITY", {1, -2, -0.25}}});
}

TEST(Slam3d, AnEdgeRefusesAParameterThatIsNotACamera) {
  g2o::SparseOptimizer optimizer;
  std::istringstream in(
      "PARAMS_SE3OFFSET 0 0 0 0 0 0 0 1\n"
      "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\n"
      "VERTEX_TRACKXYZ 1 1 2 3\n"
      "EDGE_PROJECT_DEPTH 0 1 0 34 122 3.5" +
      omega(3) + "\n");
  EXPECT_FALSE(optimizer.load(in));
  EXPECT_TRUE(optimizer.edges().empty());
}

/// An edge that projects a point with the camera in its cache, as edges of older clients do.
class EdgeThroughCache : public g2o::BaseBinaryEdge<2, g2o::Vector2, g2o::VertexSE3, g2o::VertexPointXYZ> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgeThroughCache() {
    _measurement.setZero();
    resizeParameters(1);
    installParameter(params, 0);
  }
  bool resolveCaches() override {
    g2o::ParameterVector pv(1);
    pv[0] = params;
    resolveCache(cache, static_cast<g2o::OptimizableGraph::Vertex*>(_vertices[0]), "CACHE_CAMERA", pv);
    return cache != 0;
  }
  void computeError() override {
    const auto* point = static_cast<const g2o::VertexPointXYZ*>(_vertices[1]);
    const g2o::Vector3 p = cache->w2i() * point->estimate();
    _error = p.head<2>() / p(2) - _measurement;
  }
  bool read(std::istream&) override { return false; }
  bool write(std::ostream&) const override { return false; }

 private:
  g2o::ParameterCamera* params = nullptr;
  g2o::CacheCamera* cache = nullptr;
};

/// Client edges that are derived from edges of the library and read the caches of their base classes.
class PriorThroughCache : public g2o::EdgeSE3Prior {
 public:
  void computeError() override { _error = g2o::internal::toVectorMQT(_inverseMeasurement * _cache->n2w()); }
  using g2o::EdgeSE3Prior::_cache;
};
class OffsetThroughCaches : public g2o::EdgeSE3Offset {
 public:
  void computeError() override {
    _error = g2o::internal::toVectorMQT(_inverseMeasurement * _cacheFrom->w2n() * _cacheTo->n2w());
  }
};

TEST(Slam3d, DerivedEdgesCanReadTheCachesOfTheirBaseClasses) {
  g2o::SparseOptimizer optimizer;
  std::istringstream in(
      "PARAMS_SE3OFFSET 0 0.1 0.2 0.3 0.5 -0.5 0.5 0.5\n"
      "VERTEX_SE3:QUAT 0 1 2 3 0.5 0.5 0.5 0.5\nVERTEX_SE3:QUAT 1 3 1 -0.7 0.1 -0.1 0.7 0.7\n"
      "EDGE_SE3_PRIOR 0 0 3.1 0.9 -0.6 0.5 -0.5 0.5 0.5" +
      omega(6) + "\nEDGE_SE3_OFFSET 0 1 0 0 2 0.3 -1 0.1 -0.1 0.7 0.7" + omega(6) + "\n");
  ASSERT_TRUE(optimizer.load(in));
  for (g2o::HyperGraph::Edge* loaded : g2o::HyperGraph::EdgeSet(optimizer.edges())) {
    auto* e = static_cast<g2o::OptimizableGraph::Edge*>(loaded);
    std::unique_ptr<g2o::OptimizableGraph::Edge> owned;
    if (e->vertices().size() == 1) {
      owned = std::make_unique<PriorThroughCache>();
    } else {
      owned = std::make_unique<OffsetThroughCaches>();
    }
    g2o::OptimizableGraph::Edge* const derived = owned.get();
    double z[7];
    ASSERT_TRUE(e->getMeasurementData(z) && derived->setMeasurementData(z));
    for (size_t i = 0; i < e->vertices().size(); ++i) {
      derived->setVertex(i, e->vertex(i));
      ASSERT_TRUE(derived->setParameterId(static_cast<int>(i), 0));
    }
    ASSERT_TRUE(optimizer.addEdge(owned.release()));
    for (int i = 0; i < 2; ++i) {
      e->computeError();
      derived->computeError();
      for (int k = 0; k < 6; ++k) EXPECT_NEAR(e->errorData()[k], derived->errorData()[k], 1e-6);
      const double step[] = {0.1, 0.2, -0.1, 0.1, 0.05, 0};
      optimizer.vertex(0)->oplus(step);
    }
  }
}

TEST(Slam3d, APoseConvertsToAndFromSE3Quat) {
  g2o::VertexSE3 v;
  const g2o::SE3Quat pose(g2o::Quaternion(0.8, 0, 0.6, 0), g2o::Vector3(1, 2, 3));
  v.setEstimateFromSE3Quat(pose);
  EXPECT_LT((v.estimateAsSE3Quat().toVector() - pose.toVector()).norm(), 1e-15);
}

TEST(Slam3d, TheCacheOfACameraIsUpdatedWhenItsVertexMoves) {
  g2o::SparseOptimizer optimizer;
  std::istringstream in(
      "PARAMS_CAMERACALIB 7 0.1 -0.2 0.3 0.1 -0.1 0.7 0.7 500 510 320 240\n"
      "VERTEX_SE3:QUAT 0 1 2 3 0.5 0.5 0.5 0.5\n"
      "VERTEX_TRACKXYZ 1 4 5 6\n"
      "EDGE_PROJECT_DEPTH 0 1 7 0 0 0" +
      omega(3) + "\n");
  ASSERT_TRUE(optimizer.load(in));
  auto* depth = static_cast<g2o::EdgeSE3PointXYZDepth*>(*optimizer.edges().begin());
  auto* e = new EdgeThroughCache;
  e->setVertex(0, optimizer.vertex(0));
  e->setVertex(1, optimizer.vertex(1));
  ASSERT_TRUE(e->setParameterId(0, 7));
  ASSERT_TRUE(optimizer.addEdge(e));
  for (int i = 0; i < 2; ++i) {
    e->computeError();
    depth->computeError();
    EXPECT_LT((e->error() - depth->error().head<2>()).norm(), 1e-9);
    const double step[] = {0.1, 0.2, -0.1, 0.1, 0.05, 0};
    optimizer.vertex(0)->oplus(step);
  }
}

/// A camera whose K has a skew.
struct SkewedCamera : g2o::ParameterCamera {
  SkewedCamera() {
    setKcam(500, 510, 320, 240);
    _Kcam(0, 1) = 25;
    _invKcam = _Kcam.inverse();
  }
};

template <class Edge>
void expect_skew() {
  g2o::SparseOptimizer optimizer;
  auto* camera = new SkewedCamera;
  camera->setId(7);
  ASSERT_TRUE(optimizer.addParameter(camera));
  auto* robot = new g2o::VertexSE3;
  robot->setId(0);
  auto* point = new g2o::VertexPointXYZ;
  point->setId(1);
  point->setEstimate(g2o::Vector3(1, -2, 4));
  ASSERT_TRUE(optimizer.addVertex(robot) && optimizer.addVertex(point));
  auto* edge = new Edge;
  edge->setVertex(0, robot);
  edge->setVertex(1, point);
  ASSERT_TRUE(edge->setParameterId(0, 7));
  ASSERT_TRUE(optimizer.addEdge(edge));
  edge->computeError();
  EXPECT_NEAR(edge->error()[0], 500 * 0.25 + 25 * -0.5 + 320, 1e-12);
  EXPECT_NEAR(edge->error()[1], 510 * -0.5 + 240, 1e-12);
  edge_checks::expect_exact_jacobians(*edge);
  ASSERT_TRUE(edge->setMeasurementFromState());
  edge->computeError();
  EXPECT_LT(edge->error().norm(), 1e-12);
  edge->initialEstimate({robot}, point);
  EXPECT_LT((point->estimate() - g2o::Vector3(1, -2, 4)).norm(), 1e-12);
}

TEST(Slam3d, DepthAndDisparityEdgesUseTheSkewOfACustomCamera) {
  expect_skew<g2o::EdgeSE3PointXYZDepth>();
  expect_skew<g2o::EdgeSE3PointXYZDisparity>();
}

TEST(Slam3d, GradientFunctionsOfPoseEdgesMatchCentralDifferences) {
  using g2o::internal::fromVectorMQT;
  g2o::Vector6 v;
  v << 1, 2, 3, 0.1, -0.2, 0.3;
  const g2o::Isometry3 Z = fromVectorMQT(v), Xi = fromVectorMQT(-0.7 * v),
                       Xj = fromVectorMQT(v.reverse() / 10), P = fromVectorMQT(0.3 * v);
  g2o::Isometry3 E;
  g2o::Matrix6 Ji, Jj, J;
  g2o::internal::computeEdgeSE3Gradient(E, Ji, Jj, Z, Xi, Xj, P, P);
  const auto motion = [&](const g2o::Isometry3& from, const g2o::Isometry3& to) {
    return g2o::internal::toVectorMQT(Z.inverse() * (from * P).inverse() * (to * P));
  };
  EXPECT_LT((g2o::internal::toVectorMQT(E) - motion(Xi, Xj)).norm(), 1e-14);
  g2o::internal::computeEdgeSE3PriorGradient(E, J, Z, Xi, P);
  const auto prior = [&](const g2o::Isometry3& x) { return g2o::internal::toVectorMQT(Z.inverse() * x * P); };
  for (int k = 0; k < 6; ++k) {
    const double h = 1e-6;
    const auto moved = [&](const g2o::Isometry3& x, double by) {
      g2o::Isometry3 result = x * fromVectorMQT(by * g2o::Vector6::Unit(k));
      return result;
    };
    EXPECT_LT((Ji.col(k) - (motion(moved(Xi, h), Xj) - motion(moved(Xi, -h), Xj)) / (2 * h)).norm(), 1e-8);
    EXPECT_LT((Jj.col(k) - (motion(Xi, moved(Xj, h)) - motion(Xi, moved(Xj, -h))) / (2 * h)).norm(), 1e-8);
    EXPECT_LT((J.col(k) - (prior(moved(Xi, h)) - prior(moved(Xi, -h))) / (2 * h)).norm(), 1e-8);
  }
}

TEST(Slam3d, TheDerivativeOfAQuaternionWithRespectToItsRotationMatrixIsExact) {
  for (const g2o::Vector3& q : {g2o::Vector3(0.1, -0.2, 0.3), g2o::Vector3(0.9, 0.2, -0.1)}) {
    const g2o::Matrix3 R = g2o::internal::fromCompactQuaternion(q);
    Eigen::Matrix<double, 3, 9> dq_dR;
    g2o::internal::compute_dq_dR(dq_dR, R(0, 0), R(1, 0), R(2, 0), R(0, 1), R(1, 1), R(2, 1), R(0, 2),
                                 R(1, 2), R(2, 2));
    for (int k = 0; k < 3; ++k) {
      const double h = 1e-6;
      const g2o::Vector3 step = h * g2o::Vector3::Unit(k);
      const g2o::Matrix3 dR =
          (g2o::internal::fromCompactQuaternion(q + step) - g2o::internal::fromCompactQuaternion(q - step)) /
          (2 * h);
      const Eigen::Map<const Eigen::Matrix<double, 9, 1>> columns(dR.data());
      EXPECT_LT((dq_dR * columns - g2o::Vector3::Unit(k)).norm(), 1e-8);
    }
  }
}

}  // namespace
