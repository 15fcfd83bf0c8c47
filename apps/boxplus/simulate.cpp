// SPDX-License-Identifier: BSD-3-Clause
// boxplus simulate WORLD -o FILE: makes a noisy graph with known truth.
#include "boxplus/testing/simulate.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>
#include <memory>

#include "command.h"
#include "command_line/option_kinds.h"
#include "files/format_names.h"
#include "files/graph_input.h"
#include "files/outputs.h"

namespace boxplus::app {
namespace {

constexpr const char* kFooter =
    "Worlds in space:\n"
    "  sphere     winds around a sphere from pole to pole, and sees its positions from one lap ago\n"
    "  torus      winds around a ring; the last lap meets the first\n"
    "  grid       fills a cube line by line and floor by floor, and sees its neighbors\n"
    "Worlds in the plane:\n"
    "  manhattan  walks at random through streets at right angles, and recognizes crossings\n"
    "  streets    drives each street of a town 2 to 4 times, over 100 poses from crossing to crossing,\n"
    "             and recognizes places along the way: about 4 edges per pose\n"
    "  city       drives through short streets, and sees lampposts and corners of houses ahead\n"
    "\n"
    "The same arguments give the same graph on every computer. Its estimates start at the odometry. A\n"
    "wrong loop closure (observation) mistakes one place (landmark) for another; odometry is never wrong.\n"
    "\n"
    "Example:\n"
    "  boxplus simulate streets --poses 100000 --outliers 0.05 -o streets.g2o --truth truth.g2o";

struct SimulateArguments {
  World world = World::kSphere;
  std::string output, truth;
  SimulationOptions options;
};

Choices<World> worlds_by_name() {
  Choices<World> worlds;
  for (World world : kWorlds) worlds.emplace_back(to_string(world), world);
  return worlds;
}

/// A summary of the graph in one line. Without outliers, chi2 at the truth is about the number of rows.
std::string summary(const SimulateArguments& arguments, const Simulation& simulation) {
  const auto count = [&](EdgeKind kind) {
    return std::count(simulation.kinds.begin(), simulation.kinds.end(), kind);
  };
  const auto outliers = count(EdgeKind::kOutlier), recognitions = count(EdgeKind::kRecognition) + outliers;
  return fmt::format("{}: {} vertices, {} edges, {} of them {}{}; chi2 {:.6g}, at the truth {:.6g}\n",
                     output_name(arguments.output), simulation.graph.vertex_count(), simulation.edges.size(),
                     recognitions, arguments.world == World::kCity ? "observations" : "loop closures",
                     outliers > 0 ? fmt::format(" ({} wrong)", outliers) : "", simulation.graph.chi2(),
                     simulation.truth.chi2());
}

void write(const std::string& path, Graph graph, std::vector<EdgeRef> edges) {
  GraphFile file;
  file.graph = std::move(graph);
  file.edges = std::move(edges);
  save_graph(path, file);
}

int simulate_file(const SimulateArguments& arguments) {
  const std::vector<Output> outputs{{"--output", arguments.output}, {"--truth", arguments.truth}};
  check_outputs(outputs);
  Simulation simulation = simulate(arguments.world, arguments.options);
  const std::string line = summary(arguments, simulation);
  write(arguments.output, std::move(simulation.graph), std::move(simulation.edges));
  if (!arguments.truth.empty())
    write(arguments.truth, std::move(simulation.truth), std::move(simulation.truth_edges));
  print_summary(outputs, line);
  return kSuccess;
}

}  // namespace

void add_simulate(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<SimulateArguments>();
  CLI::App* command = app.add_subcommand("simulate", "Makes a noisy graph with known truth");
  add_choice(*command, "WORLD", arguments->world, worlds_by_name(), "The path of the robot; see below")
      ->default_str("")
      ->required();
  command
      ->add_option("-o,--output", arguments->output,
                   fmt::format("Where to write the graph ({}); - is standard output", writable_formats()))
      ->type_name("FILE")
      ->check(file_name())
      ->required();
  command->add_option("--truth", arguments->truth, "Where to write the same graph at its true poses")
      ->type_name("FILE")
      ->check(file_name());
  command
      ->add_option("--poses", arguments->options.poses,
                   "The approximate number of poses; sphere, torus and grid round to whole laps")
      ->type_name("N")
      ->check(whole_number_within(2, 10'000'000))
      ->capture_default_str();
  command
      ->add_option("--seed", arguments->options.seed,
                   "Another seed gives different noise and a different town")
      ->type_name("N")
      ->check(whole_number_within(0, std::numeric_limits<long>::max()))
      ->capture_default_str();
  command->add_option("--noise", arguments->options.noise, "Factor on all standard deviations; 0: none")
      ->type_name("X")
      ->check(number_within(0, 1000))
      ->capture_default_str();
  command
      ->add_option("--outliers", arguments->options.outliers,
                   "Share of the loop closures (observations) that are wrong, 0 to 1")
      ->type_name("X")
      ->check(number_within(0, 1))
      ->capture_default_str();
  command->footer(kFooter);
  command->callback([&action, arguments] { action = [arguments] { return simulate_file(*arguments); }; });
}

}  // namespace boxplus::app
