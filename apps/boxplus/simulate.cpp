// SPDX-License-Identifier: BSD-3-Clause
// boxplus simulate WORLD -o FILE: simulates a noisy graph whose true poses are known.
#include "boxplus/testing/simulate.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>
#include <memory>
#include <variant>

#include "boxplus/testing/simulate_bundle.h"
#include "command.h"
#include "command_line/option_kinds.h"
#include "files/graph_input.h"
#include "files/outputs.h"

namespace boxplus::app {
namespace {

constexpr const char* kFooter =
    "3D worlds:\n"
    "  sphere     winds around a sphere from pole to pole, with loop closures to the previous lap\n"
    "  torus      winds around a torus, with the same loop closures; the last lap meets the first\n"
    "  grid       fills a cube line by line and floor by floor, with loop closures between neighbors\n"
    "2D worlds:\n"
    "  manhattan  walks at random through streets at right angles, with loop closures at crossings\n"
    "  streets    drives through each street of a town 2 to 4 times, with loop closures along the\n"
    "             way: about 4 edges per pose, and more than 100 poses from crossing to crossing\n"
    "  city       drives through short streets, and observes lampposts and corners of houses ahead\n"
    "Bundle adjustment, with cameras and points as in BAL files:\n"
    "  ba-ring    looks at a round building from a ring around it\n"
    "  ba-street  drives through a winding street, and looks ahead\n"
    "  ba-city    drives through all streets between square blocks, through some of them twice\n"
    "\n"
    "The same arguments give the same graph on every computer. Its initial estimates come from the\n"
    "odometry, or in bundle adjustment from the truth with noise. Outliers are loop closures to a\n"
    "wrong place, observations of a wrong landmark, or pixels anywhere in the image. The odometry\n"
    "contains no outliers.\n"
    "\n"
    "Examples:\n"
    "  boxplus simulate streets --poses 100000 --outliers 0.05 -o streets.g2o --truth truth.g2o\n"
    "  boxplus simulate ba-street --poses 2000 --points 200000 -o street.txt";

using AnyWorld = std::variant<World, BundleWorld>;

struct SimulateArguments {
  AnyWorld world = World::kSphere;
  std::string output, truth;
  SimulationOptions options;
  BundleOptions of_bundle;  // what `options` does not contain
};

Choices<AnyWorld> worlds_by_name() {
  Choices<AnyWorld> worlds;
  for (World world : kWorlds) worlds.emplace_back(to_string(world), world);
  for (BundleWorld world : kBundleWorlds) worlds.emplace_back(to_string(world), world);
  return worlds;
}

/// Returns a summary of the graph in one line. Without outliers, chi2 of the true estimates is approximately
/// the number of rows of all errors.
std::string summary(const SimulateArguments& arguments, const Simulation& simulation) {
  const auto count = [&](EdgeKind kind) {
    return std::count(simulation.kinds.begin(), simulation.kinds.end(), kind);
  };
  const auto outliers = count(EdgeKind::kOutlier), recognitions = count(EdgeKind::kRecognition) + outliers;
  return fmt::format("{}: {} vertices, {} edges, {} of them {}{}; chi2 is {:.6g}, and {:.6g} at the truth\n",
                     output_name(arguments.output), simulation.graph.vertex_count(), simulation.edges.size(),
                     recognitions,
                     arguments.world == AnyWorld(World::kCity) ? "observations" : "loop closures",
                     outliers > 0 ? fmt::format(" ({} wrong)", outliers) : "", simulation.graph.chi2(),
                     simulation.truth.chi2());
}

void write(const std::string& path, Graph graph, std::vector<EdgeRef> edges) {
  GraphFile file;
  file.graph = std::move(graph);
  file.edges = std::move(edges);
  save_graph(path, file);
}

/// Writes a BAL file, unless the extension of the path belongs to another format. Gives the graph back.
Graph write_bundle(const std::string& path, Graph graph, const std::vector<EdgeRef>& edges) {
  GraphFile file;
  file.format = "BAL";
  file.graph = std::move(graph);
  file.edges = edges;
  save_graph(path, file);
  return std::move(file.graph);
}

int simulate_bundle_file(const SimulateArguments& arguments, const std::vector<Output>& outputs) {
  BundleOptions options = arguments.of_bundle;
  options.cameras = arguments.options.poses;
  options.seed = arguments.options.seed;
  options.noise = arguments.options.noise;
  options.outliers = arguments.options.outliers;
  BundleSimulation simulation = simulate_bundle(std::get<BundleWorld>(arguments.world), options);
  const double chi2 = simulation.graph.chi2();
  const auto outliers = std::count(simulation.kinds.begin(), simulation.kinds.end(), EdgeKind::kOutlier);
  simulation.graph = write_bundle(arguments.output, std::move(simulation.graph), simulation.edges);
  simulation.set_to_truth();
  const std::string line =
      fmt::format("{}: {} cameras, {} points, {} observations{}; chi2 is {:.6g}, and {:.6g} at the truth\n",
                  output_name(arguments.output), simulation.cameras.size(), simulation.points.size(),
                  simulation.edges.size(), outliers > 0 ? fmt::format(" ({} wrong)", outliers) : "", chi2,
                  simulation.graph.chi2());
  if (!arguments.truth.empty()) write_bundle(arguments.truth, std::move(simulation.graph), simulation.edges);
  print_summary(outputs, line);
  return kSuccess;
}

int simulate_file(const SimulateArguments& arguments) {
  const std::vector<Output> outputs{{"--output", arguments.output}, {"--truth", arguments.truth}};
  check_outputs(outputs);
  if (std::holds_alternative<BundleWorld>(arguments.world)) return simulate_bundle_file(arguments, outputs);
  Simulation simulation = simulate(std::get<World>(arguments.world), arguments.options);
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
  CLI::App* command = app.add_subcommand("simulate", "Simulates a noisy graph whose true poses are known");
  add_choice(*command, "WORLD", arguments->world, worlds_by_name(), "The path of the robot; see below")
      ->default_str("")
      ->required();
  command
      ->add_option("-o,--output", arguments->output,
                   "Where to write the graph (.g2o, or BAL's .txt); - is standard output")
      ->type_name("FILE")
      ->check(file_name())
      ->required();
  command
      ->add_option("--truth", arguments->truth,
                   "Where to write the same graph with the true poses as estimates")
      ->type_name("FILE")
      ->check(file_name());
  command
      ->add_option("--poses", arguments->options.poses,
                   "The approximate number of poses; sphere, torus and grid round it to whole laps")
      ->type_name("N")
      ->check(whole_number_within(2, 10'000'000))
      ->capture_default_str();
  command->add_option("--points", arguments->of_bundle.points, "In bundle adjustment, the number of points")
      ->type_name("N")
      ->check(whole_number_within(1, 100'000'000))
      ->capture_default_str();
  command
      ->add_option("--track-length", arguments->of_bundle.track_length,
                   "In bundle adjustment, the approximate mean number of cameras that see a point")
      ->type_name("X")
      ->check(number_within(2, 1000))
      ->capture_default_str();
  command
      ->add_option("--seed", arguments->options.seed,
                   "The random seed; another seed gives different noise and a different town")
      ->type_name("N")
      ->check(whole_number_within(0, std::numeric_limits<long>::max()))
      ->capture_default_str();
  command
      ->add_option("--noise", arguments->options.noise, "The factor for all standard deviations; 0: no noise")
      ->type_name("X")
      ->check(number_within(0, 1000))
      ->capture_default_str();
  command
      ->add_option("--outliers", arguments->options.outliers,
                   "The fraction of loop closures (or observations) that are outliers, from 0 to 1")
      ->type_name("X")
      ->check(number_within(0, 1))
      ->capture_default_str();
  command->footer(kFooter);
  command->callback([&action, arguments] { action = [arguments] { return simulate_file(*arguments); }; });
}

}  // namespace boxplus::app
