// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/batch_stats.h"

#include <ostream>

namespace g2o {
namespace {

thread_local G2OBatchStatistics* global_statistics = nullptr;

}  // namespace

G2OBatchStatistics::G2OBatchStatistics() = default;

G2OBatchStatistics* G2OBatchStatistics::globalStats() {
  return global_statistics;
}

void G2OBatchStatistics::setGlobalStats(G2OBatchStatistics* b) {
  global_statistics = b;
}

std::ostream& operator<<(std::ostream& os, const G2OBatchStatistics& st) {
  const auto put = [&os](const char* name, auto value) { os << name << "= " << value << "\t "; };
  put("iteration", st.iteration);
  put("numVertices", st.numVertices);
  put("numEdges", st.numEdges);
  put("chi2", st.chi2);
  put("timeResiduals", st.timeResiduals);
  put("timeLinearize", st.timeLinearize);
  put("timeQuadraticForm", st.timeQuadraticForm);
  put("levenbergIterations", st.levenbergIterations);
  put("timeSchurComplement", st.timeSchurComplement);
  put("timeSymbolicDecomposition", st.timeSymbolicDecomposition);
  put("timeNumericDecomposition", st.timeNumericDecomposition);
  put("timeLinearSolution", st.timeLinearSolution);
  put("timeLinearSolver", st.timeLinearSolver);
  put("iterationsLinearSolver", st.iterationsLinearSolver);
  put("timeUpdate", st.timeUpdate);
  put("timeIteration", st.timeIteration);
  put("timeMarginals", st.timeMarginals);
  put("hessianDimension", st.hessianDimension);
  put("hessianPoseDimension", st.hessianPoseDimension);
  put("hessianLandmarkDimension", st.hessianLandmarkDimension);
  put("choleskyNNZ", st.choleskyNNZ);
  return os;
}

}  // namespace g2o
