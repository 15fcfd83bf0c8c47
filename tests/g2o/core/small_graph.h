// SPDX-License-Identifier: BSD-3-Clause
// A small pose graph for tests: four poses on a loop, with slightly inconsistent measurements.
#pragma once

#include <memory>
#include <vector>

#include "g2o/core/block_solver.h"
#include "g2o/core/optimization_algorithm_gauss_newton.h"
#include "g2o/core/optimization_algorithm_levenberg.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/solvers/eigen/linear_solver_eigen.h"
#include "g2o/types/slam2d/types_slam2d.h"

namespace small_graph {

using LinearSolver = g2o::LinearSolverEigen<g2o::BlockSolverX::PoseMatrixType>;

inline std::unique_ptr<g2o::BlockSolverX> make_solver() {
  return std::make_unique<g2o::BlockSolverX>(std::make_unique<LinearSolver>());
}

inline g2o::VertexSE2* add_pose(g2o::SparseOptimizer& optimizer, int id, double x, double y, double theta) {
  auto* v = new g2o::VertexSE2;
  v->setId(id);
  v->setEstimate(g2o::SE2(x, y, theta));
  EXPECT_TRUE(optimizer.addVertex(v));
  return v;
}

inline g2o::EdgeSE2* add_motion(g2o::SparseOptimizer& optimizer, int from, int to, const g2o::SE2& z,
                                double weight = 1) {
  auto* e = new g2o::EdgeSE2;
  e->setVertex(0, optimizer.vertex(from));
  e->setVertex(1, optimizer.vertex(to));
  e->setMeasurement(z);
  e->setInformation(Eigen::Matrix3d::Identity() * weight);
  EXPECT_TRUE(optimizer.addEdge(e));
  return e;
}

/// Adds four poses at the corners of a square with sides of 1 m. The measured motions along the sides do not
/// quite return to the start. Pose 0 is fixed.
inline void add_square(g2o::SparseOptimizer& optimizer) {
  const double turn = 1.5707963267948966;
  add_pose(optimizer, 0, 0, 0, 0)->setFixed(true);
  add_pose(optimizer, 1, 1.1, 0.1, turn);
  add_pose(optimizer, 2, 0.9, 1.2, 2 * turn);
  add_pose(optimizer, 3, -0.1, 0.9, -turn);
  for (int i = 0; i < 4; ++i)
    add_motion(optimizer, i, (i + 1) % 4, g2o::SE2(1 + 0.02 * i, 0.01, turn), 1 + i);
}

}  // namespace small_graph
