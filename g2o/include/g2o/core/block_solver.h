// SPDX-License-Identifier: BSD-3-Clause
// BlockSolver, the library's implementation of Solver. It builds the Hessian in blocks, eliminates
// marginalized vertices by the Schur complement, and passes the remaining system to a LinearSolver.
#pragma once
#ifndef G2O_BLOCK_SOLVER_H
#define G2O_BLOCK_SOLVER_H

#include <memory>
#include <string>
#include <typeinfo>
#include <utility>
#include <vector>

#include "g2o/core/block_solver_engine.h"
#include "g2o/core/linear_solver.h"
#include "g2o/core/solver.h"

namespace g2o {

/// The block types of a BlockSolver. Landmarks are the marginalized vertices, which the Schur complement
/// eliminates. Poses are all other vertices.
template <int _PoseDim, int _LandmarkDim>
struct BlockSolverTraits {
  static constexpr int PoseDim = _PoseDim;
  static constexpr int LandmarkDim = _LandmarkDim;
  using PoseMatrixType = Eigen::Matrix<double, PoseDim, PoseDim, Eigen::ColMajor>;
  using LandmarkMatrixType = Eigen::Matrix<double, LandmarkDim, LandmarkDim, Eigen::ColMajor>;
  using PoseLandmarkMatrixType = Eigen::Matrix<double, PoseDim, LandmarkDim, Eigen::ColMajor>;
  using PoseVectorType = Eigen::Matrix<double, PoseDim, 1, Eigen::ColMajor>;
  using LandmarkVectorType = Eigen::Matrix<double, LandmarkDim, 1, Eigen::ColMajor>;

  using PoseHessianType = SparseBlockMatrix<PoseMatrixType>;
  using LandmarkHessianType = SparseBlockMatrix<LandmarkMatrixType>;
  using PoseLandmarkHessianType = SparseBlockMatrix<PoseLandmarkMatrixType>;
  using LinearSolverType = LinearSolver<PoseMatrixType>;
};

/// The block types for vertices whose dimensions are known only at run time.
template <>
struct BlockSolverTraits<Eigen::Dynamic, Eigen::Dynamic> {
  static constexpr int PoseDim = Eigen::Dynamic;
  static constexpr int LandmarkDim = Eigen::Dynamic;
  using PoseMatrixType = MatrixX;
  using LandmarkMatrixType = MatrixX;
  using PoseLandmarkMatrixType = MatrixX;
  using PoseVectorType = VectorX;
  using LandmarkVectorType = VectorX;

  using PoseHessianType = SparseBlockMatrix<PoseMatrixType>;
  using LandmarkHessianType = SparseBlockMatrix<LandmarkMatrixType>;
  using PoseLandmarkHessianType = SparseBlockMatrix<PoseLandmarkMatrixType>;
  using LinearSolverType = LinearSolver<PoseMatrixType>;
};

class G2O_CORE_API BlockSolverBase : public Solver {
 public:
  ~BlockSolverBase() override;
  /// Computes dest = H · src.
  virtual void multiplyHessian(double* dest, const double* src) const = 0;
};

/// The traits determine the type of the LinearSolver and the dimension of the marginalized vertices. They do
/// not change the storage of H (see BlockSolverEngine). A BlockSolver owns its linear solver.
template <typename Traits>
class BlockSolver : public BlockSolverBase {
 public:
  static constexpr int PoseDim = Traits::PoseDim;
  static constexpr int LandmarkDim = Traits::LandmarkDim;
  using PoseMatrixType = typename Traits::PoseMatrixType;
  using LandmarkMatrixType = typename Traits::LandmarkMatrixType;
  using PoseLandmarkMatrixType = typename Traits::PoseLandmarkMatrixType;
  using PoseVectorType = typename Traits::PoseVectorType;
  using LandmarkVectorType = typename Traits::LandmarkVectorType;
  using PoseHessianType = typename Traits::PoseHessianType;
  using LandmarkHessianType = typename Traits::LandmarkHessianType;
  using PoseLandmarkHessianType = typename Traits::PoseLandmarkHessianType;
  using LinearSolverType = typename Traits::LinearSolverType;

  explicit BlockSolver(std::unique_ptr<LinearSolverType> linearSolver)
      : _linearSolver(std::move(linearSolver)) {}
  /// For clients that pass a raw pointer. The block solver takes ownership.
  explicit BlockSolver(LinearSolverType* linearSolver) : _linearSolver(linearSolver) {}

  bool init(SparseOptimizer* optimizer, bool online = false) override;
  bool buildStructure(bool zeroBlocks = false) override;
  /// Builds the whole structure again, because this costs little compared with a factorization. If there is
  /// no structure yet, does nothing, because the next optimize() builds it.
  bool updateStructure(const std::vector<HyperGraph::Vertex*>&, const HyperGraph::EdgeSet&) override {
    return !engine_.hasStructure() || buildStructure();
  }
  /// If the structure is outdated, builds it first, because an online optimize() does not call
  /// buildStructure().
  bool buildSystem() override {
    if (this->_optimizer == nullptr) return false;
    if (!engine_.isCurrent(*this->_optimizer) && !(_linearSolver->init() && buildStructure())) return false;
    engine_.buildSystem(*this->_optimizer, this->_b);
    if (isDerived()) copyHessian();
    return true;
  }
  /// A derived class may need the errors before it calls this class's buildSystem().
  bool computesErrors() const override { return !isDerived(); }
  bool solve() override;
  bool computeMarginals(SparseBlockMatrix<MatrixX>& spinv,
                        const std::vector<std::pair<int, int>>& blockIndices) override;
  bool setLambda(double lambda, bool = false) override {
    lambda_ = lambda;
    return true;
  }
  void restoreDiagonal() override { lambda_ = 0; }
  bool supportsSchur() override { return true; }
  bool schur() override { return _doSchur; }
  void setSchur(bool s) override { _doSchur = s; }

  LinearSolver<PoseMatrixType>& linearSolver() const { return *_linearSolver; }

  void setWriteDebug(bool writeDebug) override {
    if (_linearSolver != nullptr) _linearSolver->setWriteDebug(writeDebug);
  }
  bool writeDebug() const override { return _linearSolver != nullptr && _linearSolver->writeDebug(); }
  bool saveHessian(const std::string& fileName) const override { return engine_.save(fileName); }
  void multiplyHessian(double* dest, const double* src) const override { engine_.multiply(dest, src); }

 protected:
  std::unique_ptr<LinearSolverType> _linearSolver;
  bool _doSchur = true;

  /// Copies of the blocks of H, without damping. _Hpp has the upper triangle of the pose blocks. _Hll has the
  /// landmark blocks. _Hpl has the blocks between poses (rows) and landmarks (columns). buildSystem() fills
  /// the copies only in derived classes. Writing to a copy does not change H.
  std::unique_ptr<PoseHessianType> _Hpp;
  std::unique_ptr<LandmarkHessianType> _Hll;
  std::unique_ptr<PoseLandmarkHessianType> _Hpl;
  /// The matrix that LinearSolver::solve() receives: the upper triangle of H + λI after the elimination of
  /// the landmarks. It is nullptr if the engine (the library boxplus) solves the system without
  /// LinearSolver::solve(). The engine never does this for a linear solver of a client, nor for a derived
  /// class with landmarks.
  std::unique_ptr<PoseHessianType> _Hschur;
  int _numPoses = 0, _numLandmarks = 0;    ///< numbers of blocks
  int _sizePoses = 0, _sizeLandmarks = 0;  ///< numbers of scalars

 private:
  bool isDerived() const { return typeid(*this) != typeid(BlockSolver); }
  void copyHessian();
  /// Returns the settings of the linear solver, with exact steps if the algorithm does not check them.
  internal::EngineSettings engineSettings() const;
  /// Whether the algorithm adds damping and tries again if the system is not positive definite.
  bool retries() const { return this->levenberg() || this->inexactSteps(); }
  using EngineBlocks = std::vector<internal::EngineBlock>;
  bool solveByLinearSolver(const std::vector<int>& dims, const EngineBlocks& blocks, double* x, double* b);
  bool layOutReducedMatrix(const std::vector<int>& dims, const EngineBlocks& blocks);

  internal::BlockSolverEngine engine_;
  std::vector<PoseMatrixType*> reduced_blocks_;  ///< the block of _Hschur for each EngineBlock
  double lambda_ = 0;
};

/// A solver with p × p blocks for poses and l × l blocks for landmarks.
template <int p, int l>
using BlockSolverPL = BlockSolver<BlockSolverTraits<p, l>>;
using BlockSolverX = BlockSolverPL<Eigen::Dynamic, Eigen::Dynamic>;
using BlockSolver_6_3 = BlockSolverPL<6, 3>;
using BlockSolver_7_3 = BlockSolverPL<7, 3>;
using BlockSolver_3_2 = BlockSolverPL<3, 2>;

}  // namespace g2o

#include "g2o/core/block_solver.hpp"

#endif  // G2O_BLOCK_SOLVER_H
