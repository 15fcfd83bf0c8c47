// SPDX-License-Identifier: BSD-3-Clause
// boxplus plot BEFORE [AFTER] -o PICTURE.svg: draws graphs side by side.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "boxplus/base/error.h"
#include "command.h"
#include "command_line/option_kinds.h"
#include "files/graph_input.h"
#include "files/outputs.h"
#include "plot/svg.h"

namespace boxplus::app {
namespace {

constexpr const char* kFooter =
    "Poses in the order of their ids are the trajectory. Loop closures and observations are coloured by\n"
    "their chi2 per row: grey up to 1, which is what noise explains; the darker, the worse. Both panels\n"
    "have one scale of colours. Graphs in space are drawn in parallel projection.\n"
    "\n"
    "Example:\n"
    "  boxplus simulate streets -o before.g2o\n"
    "  boxplus optimize before.g2o -o after.g2o\n"
    "  boxplus plot before.g2o after.g2o -o streets.svg";

struct PlotArguments {
  ReadOptions reading;
  std::string before, after, output;
};

Scene scene_of(const std::string& path, const ReadOptions& reading, std::string title) {
  Scene scene = make_scene(load_graph(path, reading).graph, std::move(title));
  if (scene.poses + scene.landmark_count == 0) {
    throw FileError(input_name(path) + ": expected poses or points to draw, found none with a finite place");
  }
  return scene;
}

std::string title_of(const std::string& path) {
  return path == kStandardStream ? "graph" : std::filesystem::path(path).stem().string();
}

int plot_files(const PlotArguments& arguments) {
  const bool compares = !arguments.after.empty();
  if (arguments.before == kStandardStream && arguments.after == kStandardStream)
    throw InvalidArgument("plot: expected at most one graph from the standard input, got '-' twice");
  check_outputs({{"--output", arguments.output}});
  refuse_to_replace({"--output", arguments.output}, {arguments.before, arguments.after});
  std::vector<Scene> scenes;
  scenes.push_back(
      scene_of(arguments.before, arguments.reading, compares ? "before" : title_of(arguments.before)));
  if (compares) scenes.push_back(scene_of(arguments.after, arguments.reading, "after"));
  const std::string svg = svg_of(std::move(scenes));
  write_output(arguments.output, svg);
  if (arguments.output != kStandardStream) {
    fmt::print("{}: {}, {} kB\n", arguments.output, compares ? "before and after" : "one graph",
               (svg.size() + 999) / 1000);
  }
  return kSuccess;
}

}  // namespace

void add_plot(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<PlotArguments>();
  CLI::App* command = app.add_subcommand("plot", "Draws a graph, or two side by side, as an SVG picture");
  command->add_option("BEFORE", arguments->before, "A graph; - reads the standard input")
      ->check(file_name())
      ->required();
  command->add_option("AFTER", arguments->after, "The same graph, optimised")->check(file_name());
  command
      ->add_option("-o,--output", arguments->output,
                   "Where to write the picture (.svg); - is the standard output")
      ->type_name("FILE")
      ->check(file_name())
      ->required();
  add_reading_options(*command, arguments->reading);
  command->footer(kFooter);
  command->callback([&action, arguments] { action = [arguments] { return plot_files(*arguments); }; });
}

}  // namespace boxplus::app
