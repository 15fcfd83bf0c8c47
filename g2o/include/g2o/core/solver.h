// SPDX-License-Identifier: BSD-3-Clause
// The interface between algorithms and the classes that build and solve their linear systems.
#pragma once
#ifndef G2O_SOLVER_H
#define G2O_SOLVER_H

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "g2o/core/g2o_core_api.h"
#include "g2o/core/hyper_graph.h"
#include "g2o/core/sparse_block_matrix.h"
#include "g2o/stuff/macros.h"

namespace g2o {

class SparseOptimizer;

/// Builds and solves (H + λI) x = b, with H = Σ JᵀΩJ and b = −Σ JᵀΩe. The sums include the active edges of an
/// optimizer.
///
/// An algorithm calls init() and buildStructure() once per structure. In each iteration it calls
/// buildSystem(), and then setLambda(), solve() and restoreDiagonal() any number of times.
class G2O_CORE_API Solver {
 public:
  Solver();
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;
  virtual ~Solver();

  virtual bool init(SparseOptimizer* optimizer, bool online = false) = 0;
  /// Allocates H for the active vertices and edges.
  virtual bool buildStructure(bool zeroBlocks = false) = 0;
  /// Adds new vertices and edges to the structure.
  virtual bool updateStructure(const std::vector<HyperGraph::Vertex*>& vset,
                               const HyperGraph::EdgeSet& edges) = 0;
  /// Linearizes the active edges and fills H and b. The errors of the edges must be up to date.
  virtual bool buildSystem() = 0;
  virtual bool solve() = 0;
  /// Computes the blocks (i, j) of H⁻¹. i and j are Hessian indices.
  virtual bool computeMarginals(SparseBlockMatrix<MatrixX>& spinv,
                                const std::vector<std::pair<int, int>>& blockIndices) = 0;
  /// Adds λ to the diagonal of H. If `backup` is true, restoreDiagonal() can undo this.
  virtual bool setLambda(double lambda, bool backup = false) = 0;
  virtual void restoreDiagonal() = 0;

  double* x() { return _x; }
  const double* x() const { return _x; }
  double* b() { return _b; }
  const double* b() const { return _b; }
  size_t vectorSize() const { return _xSize; }

  SparseOptimizer* optimizer() const { return _optimizer; }
  void setOptimizer(SparseOptimizer* optimizer) { _optimizer = optimizer; }

  bool levenberg() const { return _isLevenberg; }
  void setLevenberg(bool levenberg);

  /// Returns whether steps may be inexact. Levenberg-Marquardt and dogleg allow inexact steps, because these
  /// algorithms compare the actual decrease of chi2 with the predicted decrease. If steps must be exact, the
  /// library's direct solvers use only double precision. g2o does not have this setting.
  bool inexactSteps() const { return inexact_steps_; }
  void setInexactSteps(bool inexactSteps);

  virtual bool supportsSchur() { return false; }
  /// Returns whether the solver eliminates marginalized vertices by the Schur complement.
  virtual bool schur() = 0;
  virtual void setSchur(bool s) = 0;

  size_t additionalVectorSpace() const { return _additionalVectorSpace; }
  void setAdditionalVectorSpace(size_t s) { _additionalVectorSpace = s; }

  virtual void setWriteDebug(bool) = 0;
  virtual bool writeDebug() const = 0;
  /// Writes H to a file for Octave.
  virtual bool saveHessian(const std::string& fileName) const = 0;

  /// Returns whether buildSystem() can also compute the errors of edges that the library evaluates in
  /// batches. The algorithms then compute only the errors of the other edges before they call buildSystem().
  /// g2o does not have this function.
  virtual bool computesErrors() const { return false; }

  // Older names of functions. The g2o document uses these names.
  G2O_ATTRIBUTE_DEPRECATED(bool initializeStructure()) { return buildStructure(); }
  G2O_ATTRIBUTE_DEPRECATED(bool updateLevenbergSystem(double lambda)) { return setLambda(lambda, true); }
  G2O_ATTRIBUTE_DEPRECATED(void recoverSystem(double)) { restoreDiagonal(); }

 protected:
  SparseOptimizer* _optimizer = nullptr;
  double* _x = nullptr;
  double* _b = nullptr;
  size_t _xSize = 0, _maxXSize = 0;
  bool _isLevenberg = false;
  size_t _additionalVectorSpace = 0;

  /// Resizes x and b to `sx` entries.
  void resizeVector(size_t sx);

 private:
  bool inexact_steps_ = false;
  std::vector<double> x_memory_, b_memory_;
};

}  // namespace g2o

#endif  // G2O_SOLVER_H
