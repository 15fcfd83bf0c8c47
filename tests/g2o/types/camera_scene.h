// SPDX-License-Identifier: BSD-3-Clause
// Cameras and points with the edges of visual SLAM, for tests of the g2o API.
#pragma once

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "g2o/core/block_solver.h"
#include "g2o/core/optimization_algorithm_levenberg.h"
#include "g2o/core/robust_kernel_impl.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/normal_equations.h"
#include "g2o/solvers/eigen/linear_solver_eigen.h"
#include "g2o/types/sba/types_six_dof_expmap.h"

namespace camera_scene {

using Solver = g2o::BlockSolver_6_3;

/// Cameras in a row that see points in front of them. Each point is seen by five cameras.
struct Scene {
  static constexpr int kCameras = 12, kViews = 5;

  template <class MakeEdge>
  Scene(int points, MakeEdge make_edge) {
    auto made = std::make_unique<Solver>(std::make_unique<g2o::LinearSolverEigen<Solver::PoseMatrixType>>());
    solver = made.get();
    optimizer.setAlgorithm(new g2o::OptimizationAlgorithmLevenberg(std::move(made)));
    for (int k = 0; k < kCameras; ++k) {
      auto* camera = new g2o::VertexSE3Expmap;
      camera->setId(k);
      camera->setEstimate(g2o::SE3Quat(g2o::Quaternion(1, 0.01 * std::sin(k), 0.01 * std::cos(k), 0.005),
                                       {-0.2 * k, 0.02 * (k % 3), 0.03}));
      camera->setFixed(k < 2);
      optimizer.addVertex(camera);
    }
    for (int k = 0; k < points; ++k) {
      auto* point = new g2o::VertexPointXYZ;
      point->setId(kCameras + k);
      point->setEstimate({std::sin(1.7 * k) + 1, std::cos(2.3 * k), 5 + std::sin(0.9 * k)});
      point->setMarginalized(true);
      optimizer.addVertex(point);
      for (int view = 0; view < kViews; ++view) add(make_edge(), point, (3 * k + 2 * view) % kCameras);
    }
    optimizer.initializeOptimization();
  }
  void add(g2o::EdgeSE3ProjectXYZ* edge, g2o::VertexPointXYZ* point, int camera) {
    const auto number = static_cast<double>(edges.size());
    auto* pose = static_cast<g2o::VertexSE3Expmap*>(optimizer.vertex(camera));
    edge->setVertex(0, point);
    edge->setVertex(1, pose);
    edge->fx = edge->fy = 300;
    edge->cx = 160;
    const g2o::Vector3 exact(point->estimate() + 0.02 * g2o::Vector3(std::sin(number), std::cos(number), 0));
    edge->setMeasurement(edge->cam_project(pose->estimate().map(exact)));
    g2o::Matrix2 omega;
    omega << 1, 0.1, 0.1, 0.5;
    edge->setInformation(omega);
    if (edges.size() % 4 != 0) {
      edge->setRobustKernel(new g2o::RobustKernelHuber);
      edge->robustKernel()->setDelta(1);
    }
    optimizer.addEdge(edge);
    edges.push_back(edge);
  }

  std::vector<double> system() { return normal_equations::of(optimizer, *solver, 1); }
  double chi2_after(int iterations) {
    optimizer.optimize(iterations);
    optimizer.computeActiveErrors();
    return optimizer.activeRobustChi2();
  }

  g2o::SparseOptimizer optimizer;
  Solver* solver = nullptr;
  std::vector<g2o::EdgeSE3ProjectXYZ*> edges;
};

}  // namespace camera_scene
