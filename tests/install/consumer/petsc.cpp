// SPDX-License-Identifier: BSD-3-Clause
// A program of a user that solves with PETSc.
#include <boxplus/boxplus.h>
#include <boxplus/petsc/make_petsc_solver.h>

#include <cmath>

int main() {
  boxplus::Graph graph;
  const auto a = graph.add_vertex(boxplus::SE2(0, 0, 0)), b = graph.add_vertex(boxplus::SE2(0.9, 0.1, 0));
  graph.fix(a);
  graph.add_edge(boxplus::Between(boxplus::SE2(1, 0, 0)), 1.0, a, b);
  boxplus::Options options;
  options.custom_linear_solver = boxplus::make_petsc_solver("-ksp_type cg -pc_type pbjacobi");
  const boxplus::Report report = boxplus::optimize(graph, options);
  return report.converged() && std::abs(graph.estimate(b).x() - 1) < 1e-9 ? 0 : 1;
}
