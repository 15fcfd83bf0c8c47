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

/// A method that works with a Solver.
class G2O_CORE_API OptimizationAlgorithmWithHessian : public OptimizationAlgorithm {
 public:
  explicit OptimizationAlgorithmWithHessian(Solver& solver);
  /// Takes ownership. Of nullptr comes an algorithm that cannot be initialised.
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
  Property<bool>* _writeDebug;  ///< of _properties

  /// Errors, linearisation and, in the first iteration, structure.
  bool linearize(int iteration, bool online);
  /// Returns its argument; where what the errors add up to is not finite, says which edge is to blame.
  bool blameUnless(bool finite) const;
  /// Solves and times it.
  bool solveSystem();
  /// The same with λ on the diagonal of H, which is as it was in the end.
  bool solveDamped(double lambda);

 private:
  std::unique_ptr<Solver> owned_solver_;
};

}  // namespace g2o

#endif  // G2O_OPTIMIZATION_ALGORITHM_WITH_HESSIAN_H
