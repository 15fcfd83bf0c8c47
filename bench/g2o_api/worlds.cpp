// SPDX-License-Identifier: BSD-3-Clause
#include "g2o_api/worlds.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "g2o/core/block_solver.h"
#include "g2o/core/optimization_algorithm_levenberg.h"
#include "g2o/core/robust_kernel_impl.h"
#include "g2o/solvers/dense/linear_solver_dense.h"
#include "g2o/solvers/eigen/linear_solver_eigen.h"

namespace bench {
namespace {

constexpr double kFocal = 500, kCenterX = 320, kCenterY = 240, kSigma = 1, kOutlier = 40;
const double kHuber = std::sqrt(5.991);

template <class BlockSolver, class LinearSolver>
std::unique_ptr<g2o::SparseOptimizer> make_optimizer() {
  auto optimizer = std::make_unique<g2o::SparseOptimizer>();
  optimizer->setAlgorithm(new g2o::OptimizationAlgorithmLevenberg(
      std::make_unique<BlockSolver>(std::make_unique<LinearSolver>())));
  return optimizer;
}

using Random = std::mt19937;

g2o::Vector3 normal(Random& random, double sigma) {
  std::normal_distribution<double> value(0, sigma);
  const double x = value(random), y = value(random), z = value(random);
  return {x, y, z};
}

/// A camera at `angle` on a circle of radius 8 that looks at the center: the motion from the world to the
/// camera.
g2o::SE3Quat camera_at(double angle) {
  const g2o::Vector3 center(8 * std::cos(angle), 8 * std::sin(angle), 0);
  g2o::Matrix3 R;  // the rows are the axes of the camera in the world
  R.row(2) = -center.normalized();
  R.row(1) = g2o::Vector3(0, 0, -1);
  R.row(0) = R.row(1).cross(R.row(2));
  return {R, -R * center};
}

g2o::SE3Quat disturbed(const g2o::SE3Quat& pose, Random& random, double rotation, double translation) {
  g2o::Vector6 step;
  step << normal(random, rotation), normal(random, translation);
  return g2o::SE3Quat::exp(step) * pose;
}

g2o::Vector2 image(const g2o::Vector3& p) {
  return {kFocal * p[0] / p[2] + kCenterX, kFocal * p[1] / p[2] + kCenterY};
}

g2o::Vector2 measured(const g2o::Vector3& p, Random& random, int index) {
  const double sigma = index % 10 == 9 ? kOutlier : kSigma;
  return image(p) + normal(random, sigma).head<2>();
}

template <class Edge>
void weigh(Edge& edge) {
  edge.setInformation(g2o::Matrix2::Identity() / (kSigma * kSigma));
  auto* kernel = new g2o::RobustKernelHuber;
  kernel->setDelta(kHuber);
  edge.setRobustKernel(kernel);
}

template <class Edge>
void set_camera(Edge& edge) {
  edge.fx = edge.fy = kFocal;
  edge.cx = kCenterX;
  edge.cy = kCenterY;
}

}  // namespace

std::unique_ptr<g2o::SparseOptimizer> make_bundle(const BundleSize& size) {
  auto optimizer =
      make_optimizer<g2o::BlockSolver_6_3, g2o::LinearSolverEigen<g2o::BlockSolver_6_3::PoseMatrixType>>();
  Random random(1);
  std::vector<g2o::SE3Quat> cameras;
  for (int k = 0; k < size.keyframes; ++k) {
    cameras.push_back(camera_at(6.283185307179586 * k / size.keyframes));
    auto* vertex = new g2o::VertexSE3Expmap;
    vertex->setId(k);
    vertex->setEstimate(k == 0 ? cameras[0] : disturbed(cameras.back(), random, 0.003, 0.03));
    vertex->setFixed(k < size.fixed);
    optimizer->addVertex(vertex);
  }
  int observations = 0;
  for (int k = 0; k < size.points; ++k) {
    const g2o::Vector3 point = normal(random, 1);
    auto* vertex = new g2o::VertexPointXYZ;
    vertex->setId(size.keyframes + k);
    vertex->setEstimate(point + normal(random, 0.05));
    vertex->setMarginalized(true);
    optimizer->addVertex(vertex);
    const int first = static_cast<int>(random() % static_cast<unsigned>(size.keyframes));
    for (int view = 0; view < size.views_per_point; ++view) {
      const int camera = (first + view) % size.keyframes;
      auto* edge = new g2o::EdgeSE3ProjectXYZ;
      edge->setVertex(0, vertex);
      edge->setVertex(1, optimizer->vertex(camera));
      edge->setMeasurement(
          measured(cameras[static_cast<std::size_t>(camera)].map(point), random, observations++));
      weigh(*edge);
      set_camera(*edge);
      optimizer->addEdge(edge);
    }
  }
  return optimizer;
}

PoseOnly make_pose_only(int points) {
  PoseOnly world;
  world.optimizer =
      make_optimizer<g2o::BlockSolver_6_3, g2o::LinearSolverDense<g2o::BlockSolver_6_3::PoseMatrixType>>();
  Random random(2);
  const g2o::SE3Quat camera = camera_at(0.3);
  world.start = disturbed(camera, random, 0.01, 0.1);
  world.pose = new g2o::VertexSE3Expmap;
  world.pose->setId(0);
  world.optimizer->addVertex(world.pose);
  for (int k = 0; k < points; ++k) {
    auto* edge = new g2o::EdgeSE3ProjectXYZOnlyPose;
    edge->setVertex(0, world.pose);
    edge->Xw = normal(random, 1);
    edge->setMeasurement(measured(camera.map(edge->Xw), random, k));
    weigh(*edge);
    set_camera(*edge);
    world.optimizer->addEdge(edge);
    world.edges.push_back(edge);
  }
  return world;
}

int optimize_pose(PoseOnly& world) {
  int iterations = 0;
  for (int round = 0; round < 4; ++round) {
    world.pose->setEstimate(world.start);
    world.optimizer->initializeOptimization(0);
    iterations += world.optimizer->optimize(10);
    for (g2o::EdgeSE3ProjectXYZOnlyPose* edge : world.edges) {
      if (edge->level() == 1) edge->computeError();
      edge->setLevel(edge->chi2() > kHuber * kHuber ? 1 : 0);
      if (round == 2) edge->setRobustKernel(nullptr);
    }
  }
  return iterations;
}

std::unique_ptr<g2o::SparseOptimizer> make_similarity(int points) {
  auto optimizer =
      make_optimizer<g2o::BlockSolverX, g2o::LinearSolverDense<g2o::BlockSolverX::PoseMatrixType>>();
  Random random(3);
  const g2o::SE3Quat first = camera_at(0), second = camera_at(0.2);
  const g2o::SE3Quat between = first * second.inverse();  // from the second camera to the first
  auto* vertex = new g2o::VertexSim3Expmap;
  vertex->setId(0);
  const g2o::SE3Quat start = disturbed(between, random, 0.01, 0.1);
  vertex->setEstimate(g2o::Sim3(start.rotation(), start.translation(), 1.05));
  vertex->_principle_point1 = vertex->_principle_point2 = g2o::Vector2(kCenterX, kCenterY);
  vertex->_focal_length1 = vertex->_focal_length2 = g2o::Vector2(kFocal, kFocal);
  optimizer->addVertex(vertex);
  const auto add_point = [&](int id, const g2o::Vector3& point) {
    auto* known = new g2o::VertexPointXYZ;
    known->setId(id);
    known->setEstimate(point);
    known->setFixed(true);
    optimizer->addVertex(known);
    return known;
  };
  const auto add_edge = [&](auto* edge, g2o::VertexPointXYZ* point, const g2o::Vector2& z) {
    edge->setVertex(0, point);
    edge->setVertex(1, vertex);
    edge->setMeasurement(z);
    weigh(*edge);
    optimizer->addEdge(edge);
  };
  for (int k = 0; k < points; ++k) {
    const g2o::Vector3 point = normal(random, 1), in_first = first.map(point), in_second = second.map(point);
    add_edge(new g2o::EdgeSim3ProjectXYZ, add_point(2 * k + 1, in_second), measured(in_first, random, k));
    add_edge(new g2o::EdgeInverseSim3ProjectXYZ, add_point(2 * k + 2, in_first),
             measured(in_second, random, k));
  }
  return optimizer;
}

}  // namespace bench
