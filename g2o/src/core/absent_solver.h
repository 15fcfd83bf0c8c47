// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "g2o/core/block_solver.h"
#include "g2o/stuff/logger.h"

namespace g2o {
namespace internal {

/// A placeholder for a missing solver. Its init() always fails.
class AbsentSolver : public BlockSolverBase {
 public:
  bool init(SparseOptimizer*, bool) override {
    G2O_ERROR("the algorithm was created without a solver");
    return false;
  }
  bool buildStructure(bool) override { return false; }
  bool updateStructure(const std::vector<HyperGraph::Vertex*>&, const HyperGraph::EdgeSet&) override {
    return false;
  }
  bool buildSystem() override { return false; }
  bool solve() override { return false; }
  bool computeMarginals(SparseBlockMatrix<MatrixX>&, const std::vector<std::pair<int, int>>&) override {
    return false;
  }
  bool setLambda(double, bool) override { return false; }
  void restoreDiagonal() override {}
  bool schur() override { return false; }
  void setSchur(bool) override {}
  void setWriteDebug(bool) override {}
  bool writeDebug() const override { return false; }
  bool saveHessian(const std::string&) const override { return false; }
  void multiplyHessian(double*, const double*) const override {}
};

}  // namespace internal
}  // namespace g2o
