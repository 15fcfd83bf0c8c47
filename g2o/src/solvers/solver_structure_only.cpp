// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/optimization_algorithm_factory.h"
#include "g2o/solvers/structure_only/structure_only_solver.h"

namespace g2o {
namespace {

template <int PointDoF>
class Creator : public AbstractOptimizationAlgorithmCreator {
 public:
  explicit Creator(const char* name)
      : AbstractOptimizationAlgorithmCreator({name, "optimizes only the marginalized points, each separately",
                                              "structure only", true, -1, PointDoF}) {}
  OptimizationAlgorithm* construct() override { return new StructureOnlySolver<PointDoF>; }
};

}  // namespace

G2O_REGISTER_OPTIMIZATION_LIBRARY(structure_only)
G2O_REGISTER_OPTIMIZATION_ALGORITHM(structure_only_2, new Creator<2>("structure_only_2"))
G2O_REGISTER_OPTIMIZATION_ALGORITHM(structure_only_3, new Creator<3>("structure_only_3"))

}  // namespace g2o
