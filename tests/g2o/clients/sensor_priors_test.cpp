// SPDX-License-Identifier: BSD-3-Clause
// A client that adds edges for three sensors to 3-D SLAM: an IMU at an offset, which measures gravity (with a
// parameter and a cache); a compass; and a sensor that observes walls. The edges are in namespace g2o and
// have file tags. The client saves robust kernels to a second file and restores them.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "g2o/core/base_binary_edge.h"
#include "g2o/core/base_unary_edge.h"
#include "g2o/core/block_solver.h"
#include "g2o/core/factory.h"
#include "g2o/core/optimization_algorithm_levenberg.h"
#include "g2o/core/robust_kernel_factory.h"
#include "g2o/core/robust_kernel_impl.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/solvers/eigen/linear_solver_eigen.h"
#include "g2o/stuff/macros.h"
#include "g2o/stuff/misc.h"
#include "g2o/types/slam3d/edge_se3.h"
#include "g2o/types/slam3d/edge_se3_pointxyz.h"
#include "g2o/types/slam3d/isometry3d_gradients.h"
#include "g2o/types/slam3d/parameter_se3_offset.h"
#include "g2o/types/slam3d/vertex_se3.h"
#include "g2o/types/slam3d_addons/vertex_plane.h"

namespace g2o {

/// The upward direction, measured in the frame of a sensor at an offset. The measurement consists of this
/// direction in the world and in the sensor.
class G2O_TYPES_SLAM3D_API EdgeSE3Gravity : public BaseUnaryEdge<3, Eigen::Matrix<double, 6, 1>, VertexSE3> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgeSE3Gravity() {
    information().setIdentity();
    resizeParameters(1);
    installParameter(_offsetParam, 0);
  }
  bool read(std::istream& is) override {
    int pid;
    is >> pid;
    if (!setParameterId(0, pid)) return false;
    for (int i = 0; i < 6; ++i) is >> _measurement[i];
    return readInformationMatrix(is);
  }
  bool write(std::ostream& os) const override {
    os << _offsetParam->id() << " ";
    for (int i = 0; i < 6; ++i) os << measurement()[i] << " ";
    return writeInformationMatrix(os);
  }
  void computeError() override {
    _error = _cache->w2n().linear() * _measurement.head<3>() - _measurement.tail<3>();
  }
  void setMeasurement(const Eigen::Matrix<double, 6, 1>& m) override {
    _measurement.head<3>() = m.head<3>().normalized();
    _measurement.tail<3>() = m.tail<3>().normalized();
  }
  bool setMeasurementData(const double* d) override {
    Eigen::Map<const Eigen::Matrix<double, 6, 1>> v(d);
    _measurement = v;
    return true;
  }
  bool getMeasurementData(double* d) const override {
    Eigen::Map<Eigen::Matrix<double, 6, 1>> v(d);
    v = _measurement;
    return true;
  }
  int measurementDimension() const override { return 6; }
  bool setMeasurementFromState() override {
    _measurement.tail<3>() = _cache->w2n().linear() * _measurement.head<3>();
    return true;
  }
  double initialEstimatePossible(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) override {
    return -1.;
  }

 protected:
  bool resolveCaches() override {
    ParameterVector pv(1);
    pv[0] = _offsetParam;
    resolveCache(_cache, (OptimizableGraph::Vertex*)_vertices[0], "CACHE_SE3_OFFSET", pv);
    return _cache != 0;
  }
  ParameterSE3Offset* _offsetParam = nullptr;
  CacheSE3Offset* _cache = nullptr;
};

/// The orientation that a compass measures, as a quaternion.
class EdgeSE3PriorQuat : public BaseUnaryEdge<3, Eigen::Quaterniond, VertexSE3> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  void computeError() override {
    const VertexSE3* v1 = static_cast<const VertexSE3*>(_vertices[0]);
    Eigen::Quaterniond estimate(v1->estimate().linear());
    if (_measurement.coeffs().dot(estimate.coeffs()) < 0.0) estimate.coeffs() = -estimate.coeffs();
    _error = estimate.vec() - _measurement.vec();
  }
  void setMeasurement(const Eigen::Quaterniond& m) override {
    _measurement = m;
    if (m.w() < 0.0) _measurement.coeffs() = -m.coeffs();
  }
  bool read(std::istream& is) override {
    Eigen::Quaterniond q;
    is >> q.w() >> q.x() >> q.y() >> q.z();
    setMeasurement(q);
    for (int i = 0; i < information().rows(); ++i) {
      for (int j = i; j < information().cols(); ++j) {
        is >> information()(i, j);
        if (i != j) information()(j, i) = information()(i, j);
      }
    }
    return true;
  }
  bool write(std::ostream& os) const override {
    Eigen::Quaterniond q = _measurement;
    os << q.w() << " " << q.x() << " " << q.y() << " " << q.z();
    for (int i = 0; i < information().rows(); ++i)
      for (int j = i; j < information().cols(); ++j) os << " " << information()(i, j);
    return os.good();
  }
};

/// A plane that is measured in the frame of a pose.
class EdgeSE3Plane : public BaseBinaryEdge<3, Plane3D, VertexSE3, VertexPlane> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  void computeError() override {
    const VertexSE3* v1 = static_cast<const VertexSE3*>(_vertices[0]);
    const VertexPlane* v2 = static_cast<const VertexPlane*>(_vertices[1]);
    Eigen::Isometry3d w2n = v1->estimate().inverse();
    Plane3D local_plane = w2n * v2->estimate();
    _error = local_plane.ominus(_measurement);
  }
  void setMeasurement(const Plane3D& m) override { _measurement = m; }
  bool read(std::istream& is) override {
    Vector4 v;
    is >> v(0) >> v(1) >> v(2) >> v(3);
    setMeasurement(Plane3D(v));
    return readInformationMatrix(is);
  }
  bool write(std::ostream& os) const override {
    Vector4 v = _measurement.toVector();
    os << v(0) << " " << v(1) << " " << v(2) << " " << v(3) << " ";
    return writeInformationMatrix(os);
  }
};

G2O_REGISTER_TYPE(EDGE_SE3_GRAVITY, EdgeSE3Gravity)
G2O_REGISTER_TYPE(EDGE_SE3_PRIOR_QUAT, EdgeSE3PriorQuat)
G2O_REGISTER_TYPE(EDGE_SE3_PLANE, EdgeSE3Plane)

}  // namespace g2o

G2O_USE_TYPE_GROUP(slam3d)
G2O_USE_TYPE_GROUP(slam3d_addons)

namespace {

/// A pose that does not leave its plane. It passes a modified step to its base class.
class VertexPlanar : public g2o::VertexSE3 {
 public:
  void oplusImpl(const double* update) override {
    double inPlane[6] = {update[0], update[1], 0, 0, 0, update[5]};
    VertexSE3::oplusImpl(inPlane);
  }
};

std::string kernel_type(g2o::RobustKernel* kernel) {
  if (dynamic_cast<g2o::RobustKernelHuber*>(kernel)) return "Huber";
  if (dynamic_cast<g2o::RobustKernelCauchy*>(kernel)) return "Cauchy";
  return "";
}

/// Writes one line per kernel: its name, its delta, the tag of its edge, and the vertex ids of its edge.
std::string save_robust_kernels(const g2o::SparseOptimizer& graph) {
  std::ostringstream out;
  for (const auto& edge_ : graph.edges()) {
    const g2o::OptimizableGraph::Edge* edge = static_cast<const g2o::OptimizableGraph::Edge*>(edge_);
    g2o::RobustKernel* kernel = edge->robustKernel();
    if (!kernel) continue;
    out << kernel_type(kernel) << " " << kernel->delta() << " " << g2o::Factory::instance()->tag(edge) << " "
        << edge->vertices().size();
    for (size_t i = 0; i < edge->vertices().size(); ++i) out << " " << edge->vertices()[i]->id();
    out << "\n";
  }
  return out.str();
}

void load_robust_kernels(const std::string& text, g2o::SparseOptimizer& graph) {
  std::istringstream in(text);
  std::string type, tag;
  double delta;
  for (size_t n; in >> type >> delta >> tag >> n;) {
    std::vector<int> ids(n);
    for (int& id : ids) in >> id;
    for (auto& edge_ : graph.edges()) {
      g2o::OptimizableGraph::Edge* edge = static_cast<g2o::OptimizableGraph::Edge*>(edge_);
      bool match = g2o::Factory::instance()->tag(edge) == tag && edge->vertices().size() == n;
      for (size_t i = 0; match && i < n; ++i) match = edge->vertices()[i]->id() == ids[i];
      if (!match) continue;
      g2o::RobustKernel* kernel = g2o::RobustKernelFactory::instance()->construct(type);
      kernel->setDelta(delta);
      edge->setRobustKernel(kernel);
    }
  }
}

class SensorPriors : public testing::Test {
 protected:
  static Eigen::Isometry3d pose(double x, double yaw, double pitch = 0) {
    Eigen::Isometry3d p(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
                        Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()));
    p.translation() = Eigen::Vector3d(x, 0.1 * x, 1);
    return p;
  }
  static std::unique_ptr<g2o::SparseOptimizer> make() {
    auto linear = g2o::make_unique<g2o::LinearSolverEigen<g2o::BlockSolverX::PoseMatrixType>>();
    auto optimizer = g2o::make_unique<g2o::SparseOptimizer>();
    optimizer->setAlgorithm(
        new g2o::OptimizationAlgorithmLevenberg(g2o::make_unique<g2o::BlockSolverX>(std::move(linear))));
    return optimizer;
  }
  template <class Edge>
  void add(Edge* e, std::initializer_list<int> ids) {
    size_t i = 0;
    for (int id : ids) e->setVertex(i++, graph->vertex(id));
    ASSERT_TRUE(graph->addEdge(e));
  }

  void SetUp() override {
    auto imu = std::make_unique<g2o::ParameterSE3Offset>();
    imu->setId(3);
    imu->setOffset(offset);
    ASSERT_TRUE(graph->addParameter(imu.release()));
    for (int i = 0; i < 5; ++i) {
      auto v = std::make_unique<g2o::VertexSE3>();
      v->setId(i);
      v->setEstimate(pose(i + 0.1, 0.1 * i + 0.05, 0.1));
      ASSERT_TRUE(graph->addVertex(v.release()));
    }
    auto plane = std::make_unique<g2o::VertexPlane>();
    plane->setId(9);
    plane->setFixed(true);
    plane->setEstimate(wall);
    ASSERT_TRUE(graph->addVertex(plane.release()));
    for (int i = 0; i < 5; ++i) {
      const Eigen::Isometry3d truth = pose(i, 0.1 * i);
      auto* gravity = new g2o::EdgeSE3Gravity;
      Eigen::Matrix<double, 6, 1> up;
      up << 0, 0, 1, (truth * offset).linear().transpose() * Eigen::Vector3d::UnitZ();
      gravity->setMeasurement(up);
      gravity->setInformation(Eigen::Vector3d(50, 60, 70).asDiagonal());
      ASSERT_TRUE(gravity->setParameterId(0, 3));
      add(gravity, {i});
      auto* seen = new g2o::EdgeSE3Plane;
      seen->setMeasurement(truth.inverse() * wall);
      seen->setInformation(Eigen::Matrix3d::Identity());
      add(seen, {i, 9});
      if (i == 0) continue;
      auto* motion = new g2o::EdgeSE3;
      motion->setMeasurement(pose(i - 1, 0.1 * (i - 1)).inverse() * truth);
      add(motion, {i - 1, i});
    }
    auto* compass = new g2o::EdgeSE3PriorQuat;
    compass->setMeasurement(Eigen::Quaterniond(pose(2, 0.2).linear()));
    compass->setInformation(Eigen::MatrixXd::Identity(3, 3) * 100);
    compass->setRobustKernel(g2o::RobustKernelFactory::instance()->construct("Huber"));
    add(compass, {2});
    auto* wrong = new g2o::EdgeSE3;
    wrong->setMeasurement(pose(0.5, 1));
    wrong->setRobustKernel(new g2o::RobustKernelCauchy);
    wrong->robustKernel()->setDelta(0.01);
    add(wrong, {0, 4});
  }

  double worst(g2o::SparseOptimizer& of) {
    double angle = 0;
    for (int i = 0; i < 5; ++i) {
      const auto* v = dynamic_cast<g2o::VertexSE3*>(of.vertex(i));
      const Eigen::Matrix3d off = v->estimate().linear().transpose() * pose(i, 0.1 * i).linear();
      angle = std::max(angle, Eigen::AngleAxisd(off).angle());
      angle = std::max(angle, std::abs(v->estimate().translation().y() - 0.1 * i));
    }
    return angle;
  }

  Eigen::Isometry3d offset = pose(0.2, 1, 0.3);
  g2o::Plane3D wall = g2o::Plane3D(Eigen::Vector4d(0, 1, 0, -5));
  std::unique_ptr<g2o::SparseOptimizer> graph = make();
};

TEST_F(SensorPriors, KeepPosesUprightAndAtTheirDistanceFromTheWall) {
  EXPECT_GT(worst(*graph), 0.09);
  ASSERT_TRUE(graph->initializeOptimization());
  EXPECT_GT(graph->optimize(50), 0);
  EXPECT_LT(worst(*graph), 0.01);
}

TEST_F(SensorPriors, AreRestoredFromAFileWithTheirKernels) {
  std::stringstream file;
  ASSERT_TRUE(graph->save(file));
  EXPECT_NE(file.str().find("EDGE_SE3_GRAVITY 0 3 "), std::string::npos);
  const std::string kernels = save_robust_kernels(*graph);
  const std::unique_ptr<g2o::SparseOptimizer> loaded = make();
  ASSERT_TRUE(loaded->load(file));
  EXPECT_EQ(loaded->edges().size(), graph->edges().size());
  load_robust_kernels(kernels, *loaded);
  for (auto* each : {graph.get(), loaded.get()}) {
    ASSERT_TRUE(each->initializeOptimization());
    each->computeActiveErrors();
  }
  EXPECT_NEAR(loaded->activeRobustChi2(), graph->activeRobustChi2(), 1e-12 * graph->activeRobustChi2());
  EXPECT_LT(loaded->activeRobustChi2(), loaded->activeChi2());
  EXPECT_GT(loaded->optimize(50), 0);
  EXPECT_LT(worst(*loaded), 0.01);
}

TEST_F(SensorPriors, HaveNoErrorAfterTheirMeasurementsAreSetFromTheEstimates) {
  for (auto* u : graph->edges()) {
    auto* e = static_cast<g2o::OptimizableGraph::Edge*>(u);
    if (!e->setMeasurementFromState()) continue;
    e->computeError();
    EXPECT_LT(e->chi2(), 1e-20);
    std::vector<double> z(static_cast<size_t>(e->measurementDimension()));
    ASSERT_TRUE(e->getMeasurementData(z.data()));
    ASSERT_TRUE(e->setMeasurementData(z.data()));
    e->computeError();
    EXPECT_LT(e->chi2(), 1e-20);
  }
}

TEST_F(SensorPriors, AreRefusedWithoutTheirParameter) {
  auto gravity = std::make_unique<g2o::EdgeSE3Gravity>();
  gravity->setMeasurement(Eigen::Matrix<double, 6, 1>::Ones());
  gravity->setVertex(0, graph->vertex(1));
  gravity->setParameterId(0, 4);
  EXPECT_FALSE(graph->addEdge(gravity.get()));
  gravity->setParameterId(0, 3);
  EXPECT_TRUE(graph->addEdge(gravity.get()));
  EXPECT_EQ(gravity->parameter(0), graph->parameter(3));
  ASSERT_TRUE(graph->setEdgeVertex(gravity.get(), 0, graph->vertex(2)))
      << "the edge then uses the cache of vertex 2";
  EXPECT_FALSE(graph->setEdgeVertex(gravity.get(), 0, graph->vertex(9))) << "a plane is not a pose";
  EXPECT_EQ(gravity->vertex(0), graph->vertex(2));
  gravity->computeError();
  EXPECT_TRUE(std::isfinite(gravity->chi2()));
  static_cast<void>(gravity.release());
}

TEST_F(SensorPriors, AllowAPoseThatIsRestrictedToItsPlane) {
  auto* planar = new VertexPlanar;
  planar->setId(20);
  planar->setEstimate(pose(1, 0.3));
  ASSERT_TRUE(graph->addVertex(planar));
  auto* motion = new g2o::EdgeSE3;
  motion->setMeasurement(pose(1, 0.2, 0.1));
  add(motion, {0, 20});
  g2o::HyperGraph::VertexSet alone{planar, graph->vertex(0)};
  graph->vertex(0)->setFixed(true);
  static_cast<g2o::VertexSE3*>(graph->vertex(0))->setEstimate(Eigen::Isometry3d::Identity());
  ASSERT_TRUE(graph->initializeOptimization(alone));
  EXPECT_GT(graph->optimize(20), 0);
  const Eigen::Vector3d angles = g2o::internal::toEuler(planar->estimate().linear());
  EXPECT_NEAR(angles[2], 0.2, 0.01);
  EXPECT_NEAR(angles[1], 0, 1e-12);
  EXPECT_NEAR(planar->estimate().translation().z(), 1, 1e-12);
}

}  // namespace
