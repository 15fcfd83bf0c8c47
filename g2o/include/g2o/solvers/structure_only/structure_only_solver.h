// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_STRUCTURE_ONLY_SOLVER_H
#define G2O_STRUCTURE_ONLY_SOLVER_H

// clang-format off: this header comes first, because it sets the alignment of Eigen
#include "g2o/config.h"
// clang-format on

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "g2o/core/optimization_algorithm.h"
#include "g2o/core/robust_kernel.h"
#include "g2o/core/sparse_optimizer.h"

namespace g2o {

/// Optimizes points (vertices with PointDoF dimensions) by Levenberg-Marquardt. Each point is optimized
/// separately, and all other vertices keep their estimates.
template <int PointDoF>
class StructureOnlySolver : public OptimizationAlgorithm {
 public:
  bool init(bool = false) override {
    _points.clear();
    for (OptimizableGraph::Vertex* v : optimizer()->activeVertices()) {
      if (v->marginalized() && !v->fixed() && v->dimension() == PointDoF) _points.push_back(v);
    }
    return true;
  }
  SolverResult solve(int, bool = false) override { return calc(_points, 1); }

  /// Optimizes the given points. Their edges must be in the optimizer.
  SolverResult calc(OptimizableGraph::VertexContainer& vertices, int num_iters, int num_max_trials = 10) {
    for (OptimizableGraph::Vertex* v : vertices) movePoint(*v, num_iters, num_max_trials);
    return OK;
  }

  bool computeMarginals(SparseBlockMatrix<MatrixX>&, const std::vector<std::pair<int, int>>&) override {
    return false;
  }
  bool updateStructure(const std::vector<HyperGraph::Vertex*>&, const HyperGraph::EdgeSet&) override {
    return true;
  }

  OptimizableGraph::VertexContainer& points() { return _points; }

 protected:
  OptimizableGraph::VertexContainer _points;

 private:
  using Matrix = Eigen::Matrix<double, PointDoF, PointDoF>;
  using Vector = Eigen::Matrix<double, PointDoF, 1>;

  /// Fixes all other vertices of the edges of a point until the destructor is called.
  class HoldOthers {
   public:
    explicit HoldOthers(OptimizableGraph::Vertex& point) {
      for (HyperGraph::Edge* e : point.edges()) {
        for (HyperGraph::Vertex* u : e->vertices()) {
          auto* v = static_cast<OptimizableGraph::Vertex*>(u);
          if (v == nullptr || v == &point || v->fixed()) continue;
          v->setFixed(true);
          held_.push_back(v);
        }
      }
    }
    ~HoldOthers() {
      for (OptimizableGraph::Vertex* v : held_) v->setFixed(false);
    }
    HoldOthers(const HoldOthers&) = delete;
    HoldOthers& operator=(const HoldOthers&) = delete;

   private:
    OptimizableGraph::VertexContainer held_;
  };

  static OptimizableGraph::Edge& edge(HyperGraph::Edge* e) {
    return *static_cast<OptimizableGraph::Edge*>(e);
  }

  static bool takesPart(const OptimizableGraph::Edge& e) {
    return e.level() == 0 && e.numUndefinedVertices() == 0;
  }

  static double chi2(OptimizableGraph::Vertex& point) {
    double sum = 0;
    for (HyperGraph::Edge* e : point.edges()) {
      if (!takesPart(edge(e))) continue;
      edge(e).computeError();
      if (edge(e).robustKernel() == nullptr) {
        sum += edge(e).chi2();
      } else {
        Vector3 rho;
        edge(e).robustKernel()->robustify(edge(e).chi2(), rho);
        sum += rho[0];
      }
    }
    return sum;
  }

  static void movePoint(OptimizableGraph::Vertex& point, int iterations, int max_trials) {
    constexpr double kFirstMu = 0.01, kFlat = 1e-3;
    if (point.graph() == nullptr || point.edges().empty() || point.dimension() != PointDoF) return;
    const HoldOthers hold(point);
    double* const mapped = point.hessianData();
    Matrix H;
    point.mapHessianMemory(H.data());
    double before = chi2(point), mu = kFirstMu, nu = 2;
    JacobianWorkspace& workspace = point.graph()->jacobianWorkspace();
    workspace.allocate();
    for (int iteration = 0; iteration < iterations; ++iteration) {
      H.setZero();
      point.clearQuadraticForm();
      for (HyperGraph::Edge* e : point.edges()) {
        if (!takesPart(edge(e))) continue;
        edge(e).linearizeOplus(workspace);
        edge(e).constructQuadraticForm();
      }
      const Vector b = Eigen::Map<const Vector>(point.bData());
      if (b.norm() < kFlat) break;
      bool moved = false;
      for (int trial = 0; trial < max_trials && !moved; ++trial) {
        const Vector step = (H + mu * Matrix::Identity()).ldlt().solve(b);
        point.push();
        point.oplus(step.data());
        const double after = chi2(point);
        const double gain = (before - after) / step.dot(mu * step + b);
        moved = gain > 0 && std::isfinite(after);
        if (moved) {
          point.discardTop();
          mu *= std::max(1. / 3, 1 - std::pow(2 * gain - 1, 3));
          nu = 2;
          before = after;
        } else {
          point.pop();
          mu *= nu;
          nu *= 2;
        }
      }
      if (!moved) {
        chi2(point);  // recomputes the errors, because the edges have errors of the rejected step
        break;
      }
    }
    point.mapHessianMemory(mapped);
  }
};

}  // namespace g2o

#endif  // G2O_STRUCTURE_ONLY_SOLVER_H
