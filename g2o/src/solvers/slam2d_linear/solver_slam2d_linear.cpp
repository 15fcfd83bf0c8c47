// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/solvers/slam2d_linear/solver_slam2d_linear.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "g2o/core/hyper_dijkstra.h"
#include "g2o/core/linear_engine.h"
#include "g2o/core/optimization_algorithm_factory.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/solvers/eigen/linear_solver_eigen.h"
#include "g2o/stuff/logger.h"
#include "g2o/types/slam2d/edge_se2.h"
#include "solvers/register_solvers.h"

namespace g2o {
namespace {

/// Gives the cost 1 to active edges and an infinite cost to all other edges, so that paths use only active
/// edges.
class ActiveEdgeCost : public HyperDijkstra::CostFunction {
 public:
  explicit ActiveEdgeCost(const SparseOptimizer& optimizer) : optimizer_(optimizer) {}
  double operator()(HyperGraph::Edge* e, HyperGraph::Vertex*, HyperGraph::Vertex*) override {
    const auto* edge = static_cast<const OptimizableGraph::Edge*>(e);
    return optimizer_.findActiveEdge(edge) == optimizer_.activeEdges().end()
               ? std::numeric_limits<double>::max()
               : 1;
  }

 private:
  const SparseOptimizer& optimizer_;
};

/// Adds up the measured rotations along a tree, without wrapping the sums at ±π.
class AddTurns : public HyperDijkstra::TreeAction {
 public:
  explicit AddTurns(std::vector<double>& headings) : headings_(headings) {}
  double perform(HyperGraph::Vertex* v, HyperGraph::Vertex* parent, HyperGraph::Edge* e) override {
    const auto* child = static_cast<const VertexSE2*>(v);
    if (child->hessianIndex() < 0 || e == nullptr) return 1;
    const auto* from = static_cast<const VertexSE2*>(parent);
    const auto* edge = static_cast<const EdgeSE2*>(e);
    const double turn = edge->measurement().rotation().angle();
    headings_[static_cast<size_t>(child->hessianIndex())] =
        heading(*from) + (edge->vertex(0) == parent ? turn : -turn);
    return 1;
  }
  double heading(const VertexSE2& v) const {
    return v.hessianIndex() < 0 ? v.estimate().rotation().angle()
                                : headings_[static_cast<size_t>(v.hessianIndex())];
  }

 private:
  std::vector<double>& headings_;
};

/// If the method does not support an active edge, prints a message and returns false.
bool fits(const SparseOptimizer& optimizer) {
  for (const OptimizableGraph::Edge* e : optimizer.activeEdges()) {
    if (dynamic_cast<const EdgeSE2*>(e) != nullptr) continue;
    G2O_ERROR("the linear 2-D solver supports only edges between poses (EDGE_SE2)");
    return false;
  }
  return true;
}

/// Computes headings along a spanning tree from the fixed vertices. Returns false if the tree does not reach
/// all vertices.
bool follow_tree(SparseOptimizer& optimizer, std::vector<double>& headings) {
  HyperGraph::VertexSet fixed;
  for (OptimizableGraph::Vertex* v : optimizer.activeVertices()) {
    if (v->fixed()) fixed.insert(v);
  }
  HyperDijkstra paths(&optimizer);
  ActiveEdgeCost cost(optimizer);
  paths.shortestPaths(fixed, &cost);
  for (OptimizableGraph::Vertex* v : optimizer.indexMapping()) {
    if (paths.visited().count(v) > 0) continue;
    G2O_ERROR("the linear 2-D solver needs a path from a fixed vertex to vertex {}", v->id());
    return false;
  }
  HyperDijkstra::computeTree(paths.adjacencyMap());
  AddTurns action(headings);
  HyperDijkstra::visitAdjacencyMap(paths.adjacencyMap(), &action);
  return true;
}

/// The least-squares problem whose unknowns are the headings. It is linear, because the rotations are
/// unwrapped along the tree. Its matrix is a graph Laplacian.
class Headings {
 public:
  explicit Headings(size_t count) : diagonal_(count, 0.0), b_(count, 0.0) {}

  /// Adds the cost ω (θj − θi − turn)². `r` is the residual at the current headings. An index of −1 means a
  /// fixed vertex.
  void add(int i, int j, double omega, double r) {
    if (i >= 0) diagonal_[static_cast<size_t>(i)] += omega;
    if (j >= 0) diagonal_[static_cast<size_t>(j)] += omega;
    if (i >= 0) b_[static_cast<size_t>(i)] += omega * r;
    if (j >= 0) b_[static_cast<size_t>(j)] -= omega * r;
    if (i >= 0 && j >= 0) couplings_[{std::min(i, j), std::max(i, j)}] -= omega;
  }
  bool solve(std::vector<double>& step) const {
    std::vector<internal::EngineBlock> blocks;
    auto coupling = couplings_.begin();
    for (int c = 0; c < static_cast<int>(diagonal_.size()); ++c) {
      blocks.push_back({c, c, &diagonal_[static_cast<size_t>(c)]});
      for (; coupling != couplings_.end() && coupling->first.first == c; ++coupling)
        blocks.push_back({coupling->first.second, c, &coupling->second});
    }
    internal::LinearEngine engine({internal::EngineSolver::kCholesky});
    step.resize(b_.size());
    return engine.factorize(std::vector<int>(b_.size(), 1), blocks) && engine.solve(b_.data(), step.data());
  }

 private:
  std::vector<double> diagonal_, b_;
  std::map<std::pair<int, int>, double> couplings_;  // by (column, row), with row > column
};

}  // namespace

SolverSLAM2DLinear::SolverSLAM2DLinear(std::unique_ptr<Solver> solver)
    : OptimizationAlgorithmGaussNewton(std::move(solver)) {}
SolverSLAM2DLinear::SolverSLAM2DLinear(Solver* solver) : OptimizationAlgorithmGaussNewton(solver) {}
SolverSLAM2DLinear::~SolverSLAM2DLinear() = default;

OptimizationAlgorithm::SolverResult SolverSLAM2DLinear::solve(int iteration, bool online) {
  if (iteration == 0 && !solveOrientation()) return Fail;
  return OptimizationAlgorithmGaussNewton::solve(iteration, online);
}

bool SolverSLAM2DLinear::solveOrientation() {
  const auto& mapping = _optimizer->indexMapping();
  std::vector<double> headings(mapping.size()), step;
  if (!fits(*_optimizer) || !follow_tree(*_optimizer, headings)) return false;
  const AddTurns now(headings);
  Headings system(mapping.size());
  for (const OptimizableGraph::Edge* e : _optimizer->activeEdges()) {
    if (e->numUndefinedVertices() > 0) continue;
    const auto* edge = static_cast<const EdgeSE2*>(e);
    const VertexSE2 &from = *edge->vertexXn<0>(), &to = *edge->vertexXn<1>();
    const double turn = edge->measurement().rotation().angle();
    system.add(from.hessianIndex(), to.hessianIndex(), edge->information()(2, 2),
               normalize_theta(now.heading(to) - now.heading(from) - turn));
  }
  if (!system.solve(step)) {
    G2O_ERROR("the measured rotations do not determine the headings");
    return false;
  }
  for (size_t i = 0; i < mapping.size(); ++i)
    static_cast<VertexSE2*>(mapping[i])->setEstimate(SE2(0, 0, headings[i] + step[i]));
  return true;
}

namespace {

AbstractOptimizationAlgorithmCreator* creator() {
  const OptimizationAlgorithmProperty property(
      "2dlinear", "a linear initial guess, then Gauss-Newton, for poses in the plane", "sparse Cholesky",
      false, 3, 3);
  return new internal::SolverCreator(property, [] {
    return new SolverSLAM2DLinear(
        std::make_unique<BlockSolverX>(std::make_unique<LinearSolverEigen<BlockSolverX::PoseMatrixType>>()));
  });
}

}  // namespace

G2O_REGISTER_OPTIMIZATION_LIBRARY(slam2d_linear)
G2O_REGISTER_OPTIMIZATION_ALGORITHM(2dlinear, creator())

}  // namespace g2o
