// SPDX-License-Identifier: BSD-3-Clause
// boxplus simulate WORLD -o FILE: simulates a noisy graph whose true estimates are known.
#include "boxplus/testing/simulate.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>
#include <memory>
#include <variant>

#include "boxplus/base/error.h"
#include "command.h"
#include "command_line/option_kinds.h"
#include "command_line/progress.h"
#include "files/graph_input.h"
#include "files/outputs.h"
#include "simulate/bundle.h"
#include "simulate/robot.h"

namespace boxplus::app {
namespace {

constexpr const char* kSimulateFooter =
    "3D worlds:\n"
    "  sphere     winds around a sphere from pole to pole, with loop closures to the previous lap\n"
    "  torus      winds around a torus, with the same loop closures; the last lap meets the first\n"
    "  grid       fills a cube line by line and floor by floor, with loop closures between neighbors\n"
    "  planes     flies to and fro through a row of rooms, and sees the planes of their walls, floors\n"
    "             and ceilings with a sensor whose pose on the robot is unknown, too\n"
    "  lines      the same flights, which see the lines along the edges of the rooms\n"
    "2D worlds:\n"
    "  manhattan  walks at random through streets at right angles, with loop closures at crossings\n"
    "  streets    drives through each street of a town 2 to 4 times, with loop closures along the\n"
    "             way: about 4 edges per pose, and more than 100 poses from crossing to crossing\n"
    "  city       drives through short streets, and observes lampposts and corners of houses ahead\n"
    "Robots that wander through a square, with the sensors of --sensors:\n"
    "  robot2d    points, bearings, poses (of earlier visits), compass, gps, segments\n"
    "  robot3d    points, depth and disparity (images of points), poses, compass, gps\n"
    "Bundle adjustment (cameras that observe points, written as BAL by default):\n"
    "  ba         --shape ring: cameras around an object look at it\n"
    "             --shape street: a car looks ahead, drives through streets, and never returns\n"
    "             --shape city: the car drives through each street of a town about three times\n"
    "             --shape collection: photos of the sights around a square, some of them far more\n"
    "             popular than others; almost half of all pairs of cameras share points, and tracks\n"
    "             have from 2 to hundreds of observations\n"
    "\n"
    "The same arguments give the same graph on every computer, except for rounding errors. Its initial\n"
    "estimates come from the odometry. Outliers are loop closures to a wrong place or observations of a\n"
    "wrong landmark. The odometry contains no outliers.\n"
    "In the world ba, noise has a standard deviation of --noise pixels, and outliers are at a random\n"
    "pixel. The initial estimates are the true ones plus errors.\n"
    "\n"
    "Examples:\n"
    "  boxplus simulate streets --poses 100000 --outliers 0.05 -o streets.g2o --truth truth.g2o\n"
    "  boxplus simulate ba --shape city --cameras 500 --points 50000 -o city.bal --truth truth.bal";

/// What is not one of the worlds of simulate().
enum class Special { kRobotInPlane, kRobotInSpace, kBundle };
using SceneChoice = std::variant<World, Special>;

struct SimulateArguments {
  SceneChoice scene = World::kSphere;
  std::string output, truth;
  SimulationOptions options;
  BundleArguments bundle;
  RobotArguments robot;
};

Choices<SceneChoice> scenes_by_name() {
  Choices<SceneChoice> scenes;
  for (World world : kWorlds) scenes.emplace_back(to_string(world), world);
  scenes.emplace_back("robot2d", Special::kRobotInPlane);
  scenes.emplace_back("robot3d", Special::kRobotInSpace);
  scenes.emplace_back("ba", Special::kBundle);
  return scenes;
}

bool observes_landmarks(const SceneChoice& scene) {
  return scene == SceneChoice(World::kCity) || scene == SceneChoice(World::kPlanes) ||
         scene == SceneChoice(World::kLines) || std::holds_alternative<Special>(scene);
}

Simulation simulated(const SimulateArguments& arguments) {
  Progress progress(choose_progress(false, false));
  progress.later("simulating …");
  if (const World* world = std::get_if<World>(&arguments.scene)) return simulate(*world, arguments.options);
  const bool in_space = arguments.scene == SceneChoice(Special::kRobotInSpace);
  return simulate_robot_world(in_space, arguments.robot, arguments.options);
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
                     recognitions, observes_landmarks(arguments.scene) ? "observations" : "loop closures",
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
  Simulation simulation = simulated(arguments);
  const std::string line = summary(arguments, simulation);
  write(arguments.output, std::move(simulation.graph), std::move(simulation.edges));
  if (!arguments.truth.empty())
    write(arguments.truth, std::move(simulation.truth), std::move(simulation.truth_edges));
  print_summary(outputs, line);
  return kSuccess;
}

int simulate_ba(const SimulateArguments& arguments) {
  BundleArguments bundle = arguments.bundle;
  bundle.options.seed = arguments.options.seed;
  bundle.options.noise = arguments.options.noise;
  bundle.options.outliers = arguments.options.outliers;
  return simulate_bundle_file(bundle, arguments.output, arguments.truth);
}

/// Throws InvalidArgument if one of the options was given, which the world does not have.
void refuse(const std::vector<CLI::Option*>& options, const char* worlds) {
  for (const CLI::Option* option : options) {
    if (option->count() > 0)
      throw InvalidArgument(fmt::format("{}: expected this option only with {}", option->get_name(), worlds));
  }
}

}  // namespace

void add_simulate(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<SimulateArguments>();
  CLI::App* command =
      app.add_subcommand("simulate", "Simulates a noisy graph whose true estimates are known");
  add_choice(*command, "WORLD", arguments->scene, scenes_by_name(),
             "The path of the robot, or ba for bundle adjustment; see below")
      ->default_str("")
      ->required();
  command
      ->add_option("-o,--output", arguments->output,
                   "Where to write the graph (.g2o; world ba: BAL's .bal, .ply, or a folder for COLMAP); "
                   "- is standard output")
      ->type_name("FILE")
      ->check(file_name())
      ->required();
  command->add_option("--truth", arguments->truth, "Where to write the same graph with the true estimates")
      ->type_name("FILE")
      ->check(file_name());
  CLI::Option* poses =
      command
          ->add_option("--poses", arguments->options.poses,
                       "The approximate number of poses; sphere, torus and grid round it to whole laps")
          ->type_name("N")
          ->check(whole_number_within(2, 10'000'000))
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
  command->footer(kSimulateFooter);
  const std::vector<CLI::Option*> bundle = add_bundle_options(*command, arguments->bundle);
  const std::vector<CLI::Option*> robot = add_robot_options(*command, arguments->robot);
  command->callback([&action, arguments, poses, bundle, robot] {
    action = [arguments, poses, bundle, robot] {
      const bool is_bundle = arguments->scene == SceneChoice(Special::kBundle);
      if (is_bundle || std::holds_alternative<World>(arguments->scene))
        refuse(robot, "the worlds robot2d and robot3d");
      if (!is_bundle) {
        refuse(bundle, "the world ba");
        return simulate_file(*arguments);
      }
      refuse({poses}, "worlds other than ba, which has --cameras");
      return simulate_ba(*arguments);
    };
  });
}

}  // namespace boxplus::app
