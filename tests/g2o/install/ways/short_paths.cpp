// SPDX-License-Identifier: BSD-3-Clause
// A client that includes the headers of g2o without their folders, as g2o's targets allow.
#include <cache.h>

#include "edge_se2_segment2d_pointLine.h"
#include "linear_solver_eigen.h"
#include "optimization_algorithm_gauss_newton.h"
#include "string_tools.h"
#include "types_sclam2d.h"
#include "vertex_se2.h"

int main() {
  const g2o::EdgeSE2SensorCalib edge;
  const g2o::EdgeSE2Segment2DPointLine end;
  return static_cast<int>(edge.vertices().size()) == ClientCache().size && end.pointNum() == 0 ? 0 : 1;
}
