// SPDX-License-Identifier: BSD-3-Clause
// A client that builds a map from lidar scans. Its interface uses forward declarations, and its graph grows
// between optimizations. It constructs robust kernels by name, saves and loads its map, and computes
// covariances.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <memory>
#include <sstream>
#include <string>

// Forward declarations as in a client's header. They must match the declarations in the headers of g2o.
namespace g2o {
class HyperGraph;
class SparseOptimizer;
class VertexSE3;
class VertexPointXYZ;
class EdgeSE3;
class EdgeSE3PointXYZ;
class RobustKernelFactory;
class OptimizationAlgorithm;
}  // namespace g2o

class GraphSlam {
 public:
  explicit GraphSlam(const std::string& solver_type);
  ~GraphSlam();
  g2o::VertexSE3* add_se3_node(const Eigen::Isometry3d& pose);
  g2o::VertexPointXYZ* add_point_node(const Eigen::Vector3d& p);
  g2o::EdgeSE3* add_se3_edge(g2o::VertexSE3* v1, g2o::VertexSE3* v2, const Eigen::Isometry3d& z,
                             const Eigen::MatrixXd& information);
  g2o::EdgeSE3PointXYZ* add_se3_point_edge(g2o::VertexSE3* pose, g2o::VertexPointXYZ* point,
                                           const Eigen::Vector3d& z, const Eigen::MatrixXd& information);
  void add_robust_kernel(g2o::EdgeSE3* edge, const std::string& kernel_type, double size);
  int optimize(int iterations);
  bool save(std::ostream& out) const;
  bool load(std::istream& in);
  int vertices() const;
  int edges() const;
  double chi2() const;
  Eigen::MatrixXd covariance(g2o::VertexSE3* v);

 private:
  std::unique_ptr<g2o::HyperGraph> graph;
  g2o::RobustKernelFactory* robust_kernel_factory;
};

#include "g2o/core/factory.h"
#include "g2o/core/optimization_algorithm_factory.h"
#include "g2o/core/robust_kernel.h"
#include "g2o/core/robust_kernel_factory.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/types/slam3d/edge_se3.h"
#include "g2o/types/slam3d/edge_se3_pointxyz.h"
#include "g2o/types/slam3d/parameter_se3_offset.h"
#include "g2o/types/slam3d/vertex_se3.h"

G2O_USE_OPTIMIZATION_LIBRARY(eigen)
G2O_USE_TYPE_GROUP(slam3d)

GraphSlam::GraphSlam(const std::string& solver_type)
    : graph(new g2o::SparseOptimizer()), robust_kernel_factory(g2o::RobustKernelFactory::instance()) {
  auto* optimizer = dynamic_cast<g2o::SparseOptimizer*>(graph.get());
  g2o::OptimizationAlgorithmProperty property;
  optimizer->setAlgorithm(g2o::OptimizationAlgorithmFactory::instance()->construct(solver_type, property));
  auto* offset = new g2o::ParameterSE3Offset();
  offset->setId(0);
  optimizer->addParameter(offset);
}

GraphSlam::~GraphSlam() = default;

g2o::VertexSE3* GraphSlam::add_se3_node(const Eigen::Isometry3d& pose) {
  auto* v = new g2o::VertexSE3();
  v->setId(static_cast<int>(graph->vertices().size()));
  v->setEstimate(pose);
  graph->addVertex(v);
  if (v->id() == 0) v->setFixed(true);
  return v;
}

g2o::VertexPointXYZ* GraphSlam::add_point_node(const Eigen::Vector3d& p) {
  auto* v = new g2o::VertexPointXYZ();
  v->setId(static_cast<int>(graph->vertices().size()));
  v->setEstimate(p);
  graph->addVertex(v);
  return v;
}

g2o::EdgeSE3* GraphSlam::add_se3_edge(g2o::VertexSE3* v1, g2o::VertexSE3* v2, const Eigen::Isometry3d& z,
                                      const Eigen::MatrixXd& information) {
  auto* edge = new g2o::EdgeSE3();
  edge->setMeasurement(z);
  edge->setInformation(information);
  edge->vertices()[0] = v1;
  edge->vertices()[1] = v2;
  graph->addEdge(edge);
  return edge;
}

g2o::EdgeSE3PointXYZ* GraphSlam::add_se3_point_edge(g2o::VertexSE3* pose, g2o::VertexPointXYZ* point,
                                                    const Eigen::Vector3d& z,
                                                    const Eigen::MatrixXd& information) {
  auto* edge = new g2o::EdgeSE3PointXYZ();
  edge->setMeasurement(z);
  edge->setInformation(information);
  edge->vertices()[0] = pose;
  edge->vertices()[1] = point;
  edge->setParameterId(0, 0);
  graph->addEdge(edge);
  return edge;
}

void GraphSlam::add_robust_kernel(g2o::EdgeSE3* edge, const std::string& kernel_type, double size) {
  if (kernel_type == "NONE") return;
  g2o::RobustKernel* kernel = robust_kernel_factory->construct(kernel_type);
  ASSERT_NE(kernel, nullptr);
  kernel->setDelta(size);
  edge->setRobustKernel(kernel);
}

int GraphSlam::optimize(int iterations) {
  auto* optimizer = dynamic_cast<g2o::SparseOptimizer*>(graph.get());
  if (optimizer->edges().size() < 2) return -1;
  optimizer->initializeOptimization();
  optimizer->setVerbose(false);
  return optimizer->optimize(iterations);
}

bool GraphSlam::save(std::ostream& out) const {
  return dynamic_cast<const g2o::SparseOptimizer*>(graph.get())->save(out);
}

bool GraphSlam::load(std::istream& in) {
  graph->clear();
  dynamic_cast<g2o::SparseOptimizer*>(graph.get())->clearParameters();
  return dynamic_cast<g2o::SparseOptimizer*>(graph.get())->load(in);
}

int GraphSlam::vertices() const {
  return static_cast<int>(graph->vertices().size());
}

int GraphSlam::edges() const {
  return static_cast<int>(graph->edges().size());
}

double GraphSlam::chi2() const {
  auto* optimizer = dynamic_cast<g2o::SparseOptimizer*>(graph.get());
  optimizer->initializeOptimization();
  optimizer->computeActiveErrors();
  return optimizer->chi2();
}

Eigen::MatrixXd GraphSlam::covariance(g2o::VertexSE3* v) {
  g2o::SparseBlockMatrix<g2o::MatrixX> spinv;
  if (!dynamic_cast<g2o::SparseOptimizer*>(graph.get())->computeMarginals(spinv, v)) return {};
  return *spinv.block(v->hessianIndex(), v->hessianIndex());
}

namespace {

Eigen::Isometry3d motion(double forward, double yaw) {
  Eigen::Isometry3d m = Eigen::Isometry3d::Identity();
  m.linear() = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  m.translation() = Eigen::Vector3d(forward, 0, 0);
  return m;
}

TEST(LidarSlam, AGrowingMapClosesItsLoopDespiteAWrongLoopClosure) {
  GraphSlam slam("lm_var");
  const Eigen::MatrixXd information = Eigen::MatrixXd::Identity(6, 6) * 100;
  Eigen::Isometry3d truth = Eigen::Isometry3d::Identity(), odometry = truth;
  std::vector<g2o::VertexSE3*> nodes{slam.add_se3_node(odometry)};
  const Eigen::Vector3d pole(3, 3, 1);
  g2o::VertexPointXYZ* point = slam.add_point_node(pole + Eigen::Vector3d(0.2, 0.1, 0));
  slam.add_se3_point_edge(nodes[0], point, pole, Eigen::MatrixXd::Identity(3, 3) * 100);
  for (int i = 1; i <= 40; ++i) {
    const Eigen::Isometry3d step = motion(1, i % 10 == 0 ? M_PI / 2 : 0);
    const Eigen::Isometry3d measured = step * motion(0.01, 0.004);  // odometry with drift
    truth = truth * step;
    odometry = nodes.back()->estimate() * measured;
    nodes.push_back(slam.add_se3_node(odometry));
    slam.add_se3_edge(nodes[nodes.size() - 2], nodes.back(), measured, information);
    if (i % 5 == 0) {
      slam.add_se3_point_edge(nodes.back(), point, truth.inverse() * pole,
                              Eigen::MatrixXd::Identity(3, 3) * 100);
      EXPECT_GT(slam.optimize(20), 0);
    }
  }
  slam.add_robust_kernel(slam.add_se3_edge(nodes[0], nodes[40], truth, information), "Huber", 1);
  slam.add_robust_kernel(slam.add_se3_edge(nodes[3], nodes[20], motion(5, 1), information), "Huber", 0.1);
  EXPECT_GT(slam.optimize(100), 0);
  EXPECT_LT((nodes[40]->estimate().translation() - truth.translation()).norm(), 0.3);
  EXPECT_LT((point->estimate() - pole).norm(), 0.3);
  const Eigen::MatrixXd covariance = slam.covariance(nodes[20]);
  ASSERT_EQ(covariance.rows(), 6);
  EXPECT_GT(covariance.determinant(), 0);
  EXPECT_LT((covariance - covariance.transpose()).norm(), 1e-12);
}

TEST(LidarSlam, ALoadedMapEqualsTheSavedMap) {
  GraphSlam slam("gn_var"), loaded("gn_var");
  auto* a = slam.add_se3_node(motion(0, 0));
  auto* b = slam.add_se3_node(motion(1.1, 0.3));
  auto* p = slam.add_point_node(Eigen::Vector3d(1, 2, 3));
  slam.add_se3_edge(a, b, motion(1, 0.25), Eigen::MatrixXd::Identity(6, 6) * 3);
  slam.add_se3_point_edge(a, p, Eigen::Vector3d(1, 2, 3.5), Eigen::MatrixXd::Identity(3, 3));
  std::stringstream first, second;
  ASSERT_TRUE(slam.save(first));
  ASSERT_TRUE(loaded.load(first));
  EXPECT_EQ(loaded.vertices(), 3);
  EXPECT_EQ(loaded.edges(), 2);
  EXPECT_NEAR(loaded.chi2(), slam.chi2(), 1e-12);
  ASSERT_TRUE(loaded.save(second));
  EXPECT_EQ(first.str(), second.str());
}

}  // namespace
