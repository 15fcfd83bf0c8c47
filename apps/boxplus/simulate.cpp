// SPDX-License-Identifier: BSD-3-Clause
// boxplus simulate WORLD -o FILE: makes a noisy graph whose truth is known.
#include "boxplus/testing/simulate.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <memory>

#include "boxplus/io/graph_file.h"
#include "command.h"

namespace boxplus::app {
namespace {

struct SimulateArguments {
  std::string world, output, truth;
  SimulationOptions options;
};

std::map<std::string, World> worlds_by_name() {
  std::map<std::string, World> worlds;
  for (World world : kWorlds) {
    worlds.emplace(to_string(world), world);
  }
  return worlds;
}

int simulate_file(const SimulateArguments& arguments) {
  Simulation simulation = simulate(worlds_by_name().at(arguments.world), arguments.options);
  GraphFile noisy;
  noisy.graph = std::move(simulation.graph);
  noisy.edges = std::move(simulation.edges);
  const double chi2_truth = simulation.truth.chi2();
  write_graph(arguments.output, noisy);
  if (!arguments.truth.empty()) {
    GraphFile truth;
    truth.graph = std::move(simulation.truth);
    truth.edges = std::move(simulation.truth_edges);
    write_graph(arguments.truth, truth);
  }
  fmt::print("{}: {} vertices, {} edges, chi2 {:.6g} (at the truth {:.6g})\n", arguments.output,
             noisy.graph.vertex_count(), noisy.graph.edge_count(), noisy.graph.chi2(), chi2_truth);
  return kSuccess;
}

}  // namespace

void add_simulate(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<SimulateArguments>();
  CLI::App* command = app.add_subcommand("simulate", "Makes a noisy graph whose truth is known");
  command->add_option("WORLD", arguments->world, "sphere, torus, grid (space); manhattan, landmarks (plane)")
      ->required()
      ->check(CLI::IsMember(worlds_by_name()));
  command->add_option("-o,--output", arguments->output, "Where to write the graph (.g2o)")->required();
  command->add_option("--poses", arguments->options.poses, "About so many poses")
      ->check(CLI::Range(2, 10'000'000))
      ->capture_default_str();
  command->add_option("--seed", arguments->options.seed, "Another seed, another noise")
      ->capture_default_str();
  command->add_option("--noise", arguments->options.noise, "Factor on all standard deviations")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--outliers", arguments->options.outliers, "Share")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  command->add_option("--truth", arguments->truth, "Where to write the same graph at its true places");
  command->callback([&action, arguments] { action = [arguments] { return simulate_file(*arguments); }; });
}

}  // namespace boxplus::app
