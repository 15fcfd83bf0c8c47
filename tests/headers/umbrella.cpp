// SPDX-License-Identifier: BSD-3-Clause
// boxplus.h is the only header that a program needs for pose graphs, robust kernels, covariances and files.
#include "boxplus/boxplus.h"

using namespace boxplus;

static_assert(requires(Graph graph, VertexHandle<SE2> pose, VertexHandle<Product<SE3, Vector3>> camera) {
  graph.add_edge(Between(SE2(1, 0, 0)), pose, pose);
  graph.add_edge(Prior(SE2(1, 0, 0)), pose);
  graph.estimate(camera);
  graph.set_kernel(graph.add_edge(Prior(SE2()), pose), make_robust_kernel("Huber", 1));
});
static_assert(requires(Graph graph, Options options, Optimizer optimizer, VertexRef vertex) {
  optimize(graph, options).converged();
  optimizer.run().reason == Report::Reason::kStopFlag;
  covariance(graph, {vertex}).of(vertex);
  write_graph("graph.g2o", read_graph("graph.g2o").graph);
});
