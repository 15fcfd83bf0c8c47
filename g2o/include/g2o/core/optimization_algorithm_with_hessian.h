// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_OPTIMIZATION_ALGORITHM_WITH_HESSIAN_H
#define G2O_OPTIMIZATION_ALGORITHM_WITH_HESSIAN_H

#include <memory>
#include <utility>
#include <vector>

#include "g2o/core/optimization_algorithm.h"
#include "g2o/core/solver.h"

namespace g2o {

/// The base class of algorithms that use a Solver to build and solve a linear system in each iteration.
class G2O_CORE_API OptimizationAlgorithmWithHessian : public OptimizationAlgorithm {
 public:
  explicit OptimizationAlgorithmWithHessian(Solver& solver);
  /// Takes ownership. If `solver` is nullptr, the algorithm cannot be initialized.
  explicit OptimizationAlgorithmWithHessian(Solver* solver);
  ~OptimizationAlgorithmWithHessian() override;

  bool init(bool online = false) override;
  bool computeMarginals(SparseBlockMatrix<MatrixX>& spinv,
                        const std::vector<std::pair<int, int>>& blockIndices) override;
  virtual bool buildLinearStructure();
  virtual void updateLinearSystem();
  bool updateStructure(const std::vector<HyperGraph::Vertex*>& vset,
                       const HyperGraph::EdgeSet& edges) override;

  Solver& solver() { return _solver; }
  virtual void setWriteDebug(bool writeDebug);
  virtual bool writeDebug() const { return _writeDebug->value(); }

 protected:
  Solver& _solver;
  Property<bool>* _writeDebug;  ///< owned by _properties

  /// Computes errors and Jacobians, and builds the linear system. In the first iteration, also builds the
  /// structure of the linear system.
  bool linearize(int iteration, bool online);
  /// Returns the sum of ρ(eᵀΩe) over the active edges, after linearize().
  double linearizedChi2() const;
  /// Computes the errors and returns the sum of ρ(eᵀΩe) over the active edges.
  double computeRobustChi2();
  /// Returns `finite`. If `finite` is false, logs an error. The message names an edge with a non-finite error
  /// if there is such an edge.
  bool reportUnlessFinite(bool finite) const;
  /// Solves the system and records the time.
  bool solveSystem();
  /// Adds λ to the diagonal of H, solves the system, and restores the diagonal.
  bool solveDamped(double lambda);

 private:
  std::unique_ptr<Solver> owned_solver_;
};

}  // namespace g2o

#endif  // G2O_OPTIMIZATION_ALGORITHM_WITH_HESSIAN_H
