// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_OPTIMIZATION_ALGORITHM_H
#define G2O_OPTIMIZATION_ALGORITHM_H

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

#include "g2o/core/hyper_graph.h"
#include "g2o/core/sparse_block_matrix.h"
#include "g2o/stuff/property.h"

namespace g2o {

class SparseOptimizer;

/// A method for nonlinear optimization. Each solve() performs one iteration.
class G2O_CORE_API OptimizationAlgorithm {
 public:
  enum SolverResult { Terminate = 2, OK = 1, Fail = -1 };

  OptimizationAlgorithm();
  OptimizationAlgorithm(const OptimizationAlgorithm&) = delete;
  OptimizationAlgorithm& operator=(const OptimizationAlgorithm&) = delete;
  virtual ~OptimizationAlgorithm();

  /// Called once before the iterations.
  virtual bool init(bool online = false) = 0;
  virtual SolverResult solve(int iteration, bool online = false) = 0;
  virtual bool computeMarginals(SparseBlockMatrix<MatrixX>& spinv,
                                const std::vector<std::pair<int, int>>& blockIndices) = 0;
  virtual bool updateStructure(const std::vector<HyperGraph::Vertex*>& vset,
                               const HyperGraph::EdgeSet& edges) = 0;
  /// Appends values of the algorithm, for example λ, to the line about an iteration that verbose output
  /// prints.
  virtual void printVerbose(std::ostream& os) const { (void)os; }

  const SparseOptimizer* optimizer() const { return _optimizer; }
  SparseOptimizer* optimizer() { return _optimizer; }
  void setOptimizer(SparseOptimizer* optimizer) { _optimizer = optimizer; }

  const PropertyMap& properties() const { return _properties; }
  /// Sets properties from a string such as "name=value,name=value".
  bool updatePropertiesFromString(const std::string& propString);
  void printProperties(std::ostream& os) const;

 protected:
  SparseOptimizer* _optimizer = nullptr;
  PropertyMap _properties;
};

}  // namespace g2o

#endif  // G2O_OPTIMIZATION_ALGORITHM_H
