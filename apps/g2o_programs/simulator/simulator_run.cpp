// SPDX-License-Identifier: BSD-3-Clause
#include "simulator/simulator_run.h"

#include <fmt/format.h>

namespace boxplus::programs {
namespace {

void save(const std::string& path, Graph graph, std::vector<EdgeRef> edges) {
  GraphFile file;
  file.graph = std::move(graph);
  file.edges = std::move(edges);
  save_graph(path, file);
}

}  // namespace

void declare(Arguments& arguments, SimulatorOutputs& outputs) {
  arguments.count("seed", outputs.seed, 0, std::numeric_limits<int>::max(),
                  "the random seed; the same seed gives the same graph on every computer");
  arguments.text("truth", outputs.truth, "write the same graph with the true estimates to this file");
}

void require_outputs(const SimulatorOutputs& outputs) {
  require_output(outputs.graph);
  require_output(outputs.truth);
  if (outputs.graph == outputs.truth)
    throw InvalidArgument(fmt::format("expected two different files, got '{}' twice", outputs.truth));
}

void write(Simulation simulation, const SimulatorOutputs& outputs) {
  print_remark(fmt::format("{} vertices, {} edges; chi2 = {:.6g}, and {:.6g} at the truth",
                           simulation.graph.vertex_count(), simulation.graph.edge_count(),
                           simulation.graph.chi2(), simulation.truth.chi2()));
  save(outputs.graph, std::move(simulation.graph), std::move(simulation.edges));
  if (!outputs.truth.empty())
    save(outputs.truth, std::move(simulation.truth), std::move(simulation.truth_edges));
}

}  // namespace boxplus::programs
