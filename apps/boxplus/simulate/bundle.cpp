// SPDX-License-Identifier: BSD-3-Clause
#include "simulate/bundle.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "command.h"
#include "command_line/option_kinds.h"
#include "command_line/progress.h"
#include "files/graph_input.h"
#include "files/outputs.h"

namespace boxplus::app {
namespace {

constexpr const char* kBundleGroup = "World ba";

Choices<BundleShape> shapes_by_name() {
  Choices<BundleShape> shapes;
  for (BundleShape shape : kBundleShapes) shapes.emplace_back(to_string(shape), shape);
  return shapes;
}

CLI::Option* add_factor(CLI::App& command, const char* name, double& value, const char* text) {
  return command.add_option(name, value, text)
      ->type_name("X")
      ->check(number_within(0, 1000))
      ->capture_default_str()
      ->group(kBundleGroup);
}

std::string count_of(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

/// A summary of the problem in one line, without chi2 of the truth.
std::string summary(const std::string& output, const BundleSimulation& simulation) {
  const std::size_t observations = simulation.is_outlier.size(), points = simulation.true_points.size();
  const auto outliers = std::count(simulation.is_outlier.begin(), simulation.is_outlier.end(), true);
  return fmt::format("{}: {} cameras, {}, {} observations{}, {:.2f} per point; chi2 is {:.6g}",
                     output_name(output), simulation.true_poses.size(), count_of(points, "point", "points"),
                     observations, outliers > 0 ? fmt::format(" ({} wrong)", outliers) : "",
                     static_cast<double>(observations) / static_cast<double>(points),
                     simulation.graph.chi2());
}

}  // namespace

std::vector<CLI::Option*> add_bundle_options(CLI::App& command, BundleArguments& arguments) {
  BundleOptions& options = arguments.options;
  const auto add_count = [&](const char* name, int& value, long least, long most, const char* text) {
    return command.add_option(name, value, text)
        ->type_name("N")
        ->check(whole_number_within(least, most))
        ->capture_default_str()
        ->group(kBundleGroup);
  };
  return {
      add_choice(command, "--shape", arguments.shape, shapes_by_name(),
                 "The arrangement of the cameras (see below)")
          ->group(kBundleGroup),
      add_count("--cameras", options.cameras, 2, 10'000'000, "The number of cameras"),
      add_count("--points", options.points, 1, 100'000'000, "The number of points"),
      command
          .add_option("--track-length", options.track_length,
                      "The average number of cameras that see a point; it is smaller if so many cameras "
                      "cannot see a point")
          ->type_name("X")
          ->check(number_within(2, 1000))
          ->capture_default_str()
          ->group(kBundleGroup),
      add_factor(command, "--pose-noise", options.pose_noise,
                 "The errors of the initial poses; 1: standard deviations of 0.1 m and 0.5° per axis"),
      add_factor(command, "--point-noise", options.point_noise,
                 "The errors of the initial points; 1: a standard deviation of 0.1 m per axis"),
      add_factor(command, "--intrinsics-noise", options.intrinsics_noise,
                 "The errors of the initial intrinsics; 1: standard deviations of 1 % of f, 0.01 of k1 and "
                 "0.001 of k2")};
}

int simulate_bundle_file(const BundleArguments& arguments, const std::string& output,
                         const std::string& truth) {
  const std::vector<Output> outputs{graph_output("--output", output, {}), graph_output("--truth", truth, {})};
  check_outputs(outputs);
  Progress progress(choose_progress(false, false));
  progress.later("simulating …");
  BundleSimulation simulation = simulate_bundle(arguments.shape, arguments.options);
  progress.erase();
  std::string line = summary(output, simulation);
  GraphFile file;
  file.format = "BAL";
  file.graph = std::move(simulation.graph);
  for (const std::string& path : {output, truth}) require_representable(path, file);
  save_graph(output, file);
  simulation.set_to_truth(file.graph);
  if (!truth.empty()) save_graph(truth, file);
  line += fmt::format(", and {:.6g} at the truth\n", file.graph.chi2());
  print_summary(outputs, line);
  return kSuccess;
}

}  // namespace boxplus::app
