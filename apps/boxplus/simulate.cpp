// SPDX-License-Identifier: BSD-3-Clause
// boxplus simulate WORLD -o FILE: makes a noisy graph whose truth is known.
#include "boxplus/testing/simulate.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>

#include "boxplus/base/error.h"
#include "command.h"
#include "streams.h"

namespace boxplus::app {
namespace {

constexpr const char* kFooter =
    "Worlds in space:\n"
    "  sphere     winds around a sphere from pole to pole, and sees where it was one lap ago\n"
    "  torus      winds around a ring; the last lap meets the first\n"
    "  grid       fills a cube line by line and floor by floor, and sees its neighbours\n"
    "Worlds in the plane:\n"
    "  manhattan  walks at random through streets at right angles, and knows crossings again\n"
    "  streets    drives each street of a town 2 to 4 times, over 100 poses from crossing to crossing,\n"
    "             and sees where it drove before: about 4 edges per pose\n"
    "  city       drives through short streets, and sees lampposts and corners of houses ahead\n"
    "\n"
    "The same words give the same graph on every computer. Its estimates begin at the odometry. A wrong\n"
    "loop closure (observation) takes one place (landmark) for another; odometry is never wrong.\n"
    "\n"
    "Example:\n"
    "  boxplus simulate streets --poses 100000 --outliers 0.05 -o streets.g2o --truth truth.g2o";

struct SimulateArguments {
  std::string world, output, truth;
  SimulationOptions options;
};

std::map<std::string, World> worlds_by_name() {
  std::map<std::string, World> worlds;
  for (World world : kWorlds) worlds.emplace(to_string(world), world);
  return worlds;
}

/// Accepts numbers in [low, high]; `what` they are says the complaint.
template <class Number>
CLI::Validator within(Number low, Number high, const std::string& what) {
  const auto complaint = [=](const std::string& text) {
    Number value{};
    const bool is_within = CLI::detail::lexical_cast(text, value) && value >= low && value <= high;
    return is_within ? std::string() : fmt::format("expected {}, got '{}'", what, text);
  };
  return {complaint, ""};
}

void check_outputs(const SimulateArguments& arguments) {
  if (arguments.output == arguments.truth) {
    throw InvalidArgument("simulate: expected two places for --output and --truth, got '" + arguments.truth +
                          "' for both");
  }
  require_writable_or_stdout(arguments.output);
  if (!arguments.truth.empty()) require_writable_or_stdout(arguments.truth);
}

/// What was made, in one line; chi2 at the truth is about the number of rows, but for outliers.
std::string summary(const SimulateArguments& arguments, const Simulation& simulation) {
  const auto count = [&](EdgeKind kind) {
    return std::count(simulation.kinds.begin(), simulation.kinds.end(), kind);
  };
  const auto outliers = count(EdgeKind::kOutlier), recognitions = count(EdgeKind::kRecognition) + outliers;
  return fmt::format("{}: {} vertices, {} edges, {} of them {}{}; chi2 {:.6g}, at the truth {:.6g}\n",
                     arguments.output == kStream ? "<stdout>" : arguments.output,
                     simulation.graph.vertex_count(), simulation.edges.size(), recognitions,
                     arguments.world == to_string(World::kCity) ? "observations" : "loop closures",
                     outliers > 0 ? fmt::format(" ({} wrong)", outliers) : "", simulation.graph.chi2(),
                     simulation.truth.chi2());
}

void write(const std::string& path, Graph graph, std::vector<EdgeRef> edges) {
  GraphFile file;
  file.graph = std::move(graph);
  file.edges = std::move(edges);
  if (path == kStream) {
    write_file_or_stdout(path, format_graph(file));
  } else {
    write_graph(path, file);
  }
}

int simulate_file(const SimulateArguments& arguments) {
  check_outputs(arguments);
  Simulation simulation = simulate(worlds_by_name().at(arguments.world), arguments.options);
  const std::string line = summary(arguments, simulation);
  write(arguments.output, std::move(simulation.graph), std::move(simulation.edges));
  if (!arguments.truth.empty())
    write(arguments.truth, std::move(simulation.truth), std::move(simulation.truth_edges));
  const bool takes_stdout = arguments.output == kStream || arguments.truth == kStream;
  fmt::print(takes_stdout ? stderr : stdout, "{}", line);
  return kSuccess;
}

}  // namespace

void add_simulate(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<SimulateArguments>();
  CLI::App* command = app.add_subcommand("simulate", "Makes a noisy graph whose truth is known");
  command->add_option("WORLD", arguments->world, "What the robot drives through; see below")
      ->required()
      ->check(CLI::IsMember(worlds_by_name()));
  command
      ->add_option("-o,--output", arguments->output,
                   "Where to write the graph (.g2o); - is the standard output")
      ->required();
  command->add_option("--truth", arguments->truth, "Where to write the same graph at its true places");
  command
      ->add_option("--poses", arguments->options.poses,
                   "About so many poses; sphere, torus and grid round to whole laps")
      ->check(within(2, 10'000'000, "a whole number from 2 to 10000000"))
      ->capture_default_str();
  command->add_option("--seed", arguments->options.seed, "Another seed, another noise and another town")
      ->check(within(std::int64_t{0}, std::numeric_limits<std::int64_t>::max(), "a whole number from 0"))
      ->capture_default_str();
  command->add_option("--noise", arguments->options.noise, "Factor on all standard deviations; 0: none")
      ->check(within(0.0, 1000.0, "a number from 0 to 1000"))
      ->capture_default_str();
  command
      ->add_option("--outliers", arguments->options.outliers,
                   "Share of the loop closures (observations) that are wrong, 0 to 1")
      ->check(within(0.0, 1.0, "a number from 0 to 1"))
      ->capture_default_str();
  command->footer(kFooter);
  command->callback([&action, arguments] { action = [arguments] { return simulate_file(*arguments); }; });
}

}  // namespace boxplus::app
