// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_BATCH_STATS_H_
#define G2O_BATCH_STATS_H_

#include <cstddef>
#include <iosfwd>
#include <vector>

#include "g2o/core/g2o_core_api.h"

namespace g2o {

/// The statistics of one iteration. Times are in seconds.
struct G2O_CORE_API G2OBatchStatistics {
  G2OBatchStatistics();

  int iteration = -1;
  int numVertices = 0;
  int numEdges = 0;
  double chi2 = -1;

  double timeResiduals = 0;
  double timeLinearize = 0;      // always 0, because timeQuadraticForm includes it
  double timeQuadraticForm = 0;  // time to compute the Jacobians, H and b
  int levenbergIterations = 0;
  double timeSchurComplement = 0;
  double timeSymbolicDecomposition = 0;
  double timeNumericDecomposition = 0;
  double timeLinearSolution = 0;  // time to solve the linear system, including the Schur complement
  double timeLinearSolver = 0;    // time to solve the linear system, without the Schur complement
  int iterationsLinearSolver = 0;
  double timeUpdate = 0;
  double timeIteration = 0;
  double timeMarginals = 0;  // time of computeMarginals() after this iteration

  size_t hessianDimension = 0;
  size_t hessianPoseDimension = 0;
  size_t hessianLandmarkDimension = 0;
  size_t choleskyNNZ = 0;

  /// Returns the statistics that the optimizer on this thread fills, or nullptr if it does not collect
  /// statistics.
  static G2OBatchStatistics* globalStats();
  static void setGlobalStats(G2OBatchStatistics* b);
};

using BatchStatisticsContainer = std::vector<G2OBatchStatistics>;

G2O_CORE_API std::ostream& operator<<(std::ostream&, const G2OBatchStatistics&);

}  // namespace g2o

#endif  // G2O_BATCH_STATS_H_
