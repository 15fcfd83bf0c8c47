// SPDX-License-Identifier: BSD-3-Clause
// boxplus replay FILE: gives the vertices of a file to a Smoother one by one.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>

#include "boxplus/base/error.h"
#include "boxplus/incremental/smoother.h"
#include "boxplus/optimize/optimizer.h"
#include "command.h"
#include "command_line/option_kinds.h"
#include "files/graph_input.h"
#include "guess/placement.h"

namespace boxplus::app {
namespace {

struct ReplayArguments {
  std::string input, output;
  int check = 0;
  SmootherOptions options;
  ReadOptions reading;
};

/// The edges of each step. A step adds a vertex, and the edges whose other vertices were there before.
struct Steps {
  std::vector<VertexRef> vertices;
  std::vector<std::vector<EdgeRef>> edges;
};

Steps steps_of(const Graph& graph) {
  Steps steps{graph.all_vertices(), {}};
  steps.edges.resize(steps.vertices.size());
  std::vector<std::vector<std::size_t>> step_of(graph.vertex_pools().size());
  for (std::size_t p = 0; p < step_of.size(); ++p) step_of[p].resize(graph.vertex_pools()[p]->slots());
  for (std::size_t k = 0; k < steps.vertices.size(); ++k)
    step_of[steps.vertices[k].pool][steps.vertices[k].slot] = k;
  for (const EdgeRef& edge : graph.all_edges()) {
    std::size_t last = 0;
    for (const VertexRef& vertex : graph.vertices(edge)) last = std::max(last, step_of[vertex.pool][vertex.slot]);
    steps.edges[last].push_back(edge);
  }
  return steps;
}

int replay(const ReplayArguments& arguments) {
  GraphFile file = load_graph(arguments.input, arguments.reading);
  Graph& graph = file.graph;
  const Steps steps = steps_of(graph);
  for (const EdgeRef& edge : graph.all_edges()) graph.set_level(edge, 1);
  Placement placement(graph);
  for (const VertexRef& vertex : steps.vertices) {
    if (!graph.is_fixed(vertex)) placement.expect(vertex);
  }
  Smoother smoother(graph, arguments.options);
  std::vector<double> seconds;
  double total = 0, flops = 0;
  std::uint64_t relinearized = 0, ordered = 0, refactored = 0, moved = 0, iterations = 0;
  for (std::size_t k = 0; k < steps.vertices.size(); ++k) {
    for (const EdgeRef& edge : steps.edges[k]) {
      graph.set_level(edge, 0);
      placement.place_by(edge);
    }
    placement.keep(steps.vertices[k]);
    const SmootherReport report = smoother.update();
    seconds.push_back(report.time_s);
    total += report.time_s;
    flops += report.flops;
    relinearized += report.relinearized;
    ordered += report.ordered;
    refactored += report.refactored;
    moved += report.moved;
    iterations += static_cast<std::uint64_t>(report.iterations);
    if (!report.converged() && !report.message.empty()) fmt::print("step {}: {}\n", k, report.message);
    if (arguments.check > 0 && k % static_cast<std::size_t>(arguments.check) == 99) {
      double chi2 = 0;
      Graph copy = graph;
      for (const EdgeRef& edge : copy.all_edges()) {
        if (copy.level(edge) == 0) chi2 += copy.chi2(edge);
      }
      const Report batch = optimize(copy, {.start = Start::kAutomatic, .threads = 1});
      fmt::print("{} chi2 {:.9g} batch {:.9g} excess {:.2e}\n", k, chi2, batch.chi2_final,
                 chi2 / batch.chi2_final - 1);
    }
  }
  total += smoother.finish().time_s;
  const std::size_t worst = static_cast<std::size_t>(
      std::max_element(seconds.begin(), seconds.end()) - seconds.begin());
  const double worst_s = seconds[worst];
  std::nth_element(seconds.begin(), seconds.begin() + seconds.size() / 2, seconds.end());
  fmt::print("chi2 {:.10g}, total {:.3f} s, worst {:.2f} ms (step {}), median {:.1f} us\n", graph.chi2(), total,
             1e3 * worst_s, worst, 1e6 * seconds[seconds.size() / 2]);
  fmt::print("iterations {}, relinearized edges {}, ordered {}, fronts {}, moved {}, Gflop {:.3f}\n", iterations,
             relinearized, ordered, refactored, moved, 1e-9 * flops);
  if (!arguments.output.empty()) save_graph(arguments.output, file);
  return kSuccess;
}

}  // namespace

void add_replay(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<ReplayArguments>();
  CLI::App& command = *app.add_subcommand("replay", "Optimize a graph step by step, as a robot would");
  command.add_option("FILE", arguments->input, "The graph")->required();
  command.add_option("-o,--output", arguments->output, "The result");
  command.add_option("--check", arguments->check, "");
  command.add_option("--iterations", arguments->options.max_iterations, "");
  command.add_option("--relinearize-length", arguments->options.relinearize.length, "");
  command.add_option("--relinearize-angle", arguments->options.relinearize.angle, "");
  command.add_option("--noticeable-length", arguments->options.noticeable.length, "");
  command.add_option("--noticeable-angle", arguments->options.noticeable.angle, "");
  command.callback([arguments, &action] { action = [arguments] { return replay(*arguments); }; });
}

}  // namespace boxplus::app
