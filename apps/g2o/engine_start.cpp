// SPDX-License-Identifier: BSD-3-Clause
#include "engine_start.h"

#include <iostream>
#include <locale>
#include <memory>
#include <sstream>

#include "boxplus/base/error.h"
#include "boxplus/io/graph_file.h"
#include "boxplus/io/registry.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/robust/make_robust_kernel.h"
#include "g2o/core/factory.h"
#include "io/printable.h"
#include "session.h"

namespace g2o_tool {
namespace {

/// The part of the graph that the engine knows.
boxplus::Graph known_part(const g2o::SparseOptimizer& optimizer) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  optimizer.save(text);
  boxplus::GraphFile file = boxplus::parse_graph(text.str(), "the graph", {.lenient = true});
  return std::move(file.graph);
}

/// Returns false if the engine does not know the kernel.
bool add_kernels(boxplus::Graph& graph, const EngineStartOptions& options) {
  if (options.robust_kernel.empty()) return true;
  const double width = options.robust_kernel_width > 0 ? options.robust_kernel_width : 1;
  try {
    const std::shared_ptr<const boxplus::RobustKernel> kernel =
        boxplus::make_robust_kernel(options.robust_kernel, width);
    for (const boxplus::EdgeRef& edge : graph.all_edges()) graph.set_kernel(edge, kernel);
    return true;
  } catch (const boxplus::InvalidArgument&) {
    return false;
  }
}

void copy_estimates(const boxplus::Graph& graph, g2o::SparseOptimizer& optimizer) {
  for (const boxplus::VertexRef& from : graph.all_vertices()) {
    g2o::OptimizableGraph::Vertex* to = optimizer.vertex(static_cast<int>(graph.id(from)));
    const boxplus::Tag* tag = boxplus::default_registry().tag_of(graph, from);
    const bool is_same = to != nullptr && tag != nullptr && g2o::Factory::instance()->tag(to) == tag->name;
    if (!is_same || to->fixed()) continue;
    std::string fields;
    boxplus::FieldWriter out(fields);
    tag->write_vertex(graph, from, out);
    std::istringstream in(fields);
    in.imbue(std::locale::classic());
    to->read(in);
  }
}

}  // namespace

void start_with_engine(g2o::SparseOptimizer& optimizer, const EngineStartOptions& options) {
  boxplus::Graph graph = known_part(optimizer);
  if (graph.edge_count() == 0) {
    std::cerr << "# the engine knows no edge of the graph, so the start is that of the file\n";
    return;
  }
  boxplus::Options engine;
  engine.start = boxplus::Start::kAutomatic;
  engine.max_iterations = add_kernels(graph, options) ? options.iterations : 0;
  engine.callback = [&](const boxplus::IterationRecord&) { return !optimizer.terminate(); };
  const boxplus::Report report = boxplus::optimize(graph, engine);
  if (options.print_report) std::cerr << report;
  const double before = chi2(optimizer);
  optimizer.push();
  copy_estimates(graph, optimizer);
  const double after = chi2(optimizer);
  std::cerr << "# start of the engine: chi2 = " << after << " after " << report.iterations
            << " iterations from "
            << (report.start.used == boxplus::Start::kCurrent ? "the current estimates" : "the chordal guess")
            << '\n';
  if (after < before) {
    optimizer.discardTop();
  } else {
    optimizer.pop();
  }
}

}  // namespace g2o_tool
