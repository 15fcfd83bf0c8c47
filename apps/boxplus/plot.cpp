// SPDX-License-Identifier: BSD-3-Clause
// boxplus plot BEFORE [AFTER] -o PICTURE.svg: draws graphs side by side.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "boxplus/io/graph_file.h"
#include "command.h"
#include "svg.h"

namespace boxplus::app {
namespace {

struct PlotArguments {
  std::string before, after, output;
};

int plot_files(const PlotArguments& arguments) {
  std::vector<Scene> scenes;
  const bool compares = !arguments.after.empty();
  scenes.push_back(make_scene(read_graph(arguments.before).graph, compares ? "before" : "graph"));
  if (compares) scenes.push_back(make_scene(read_graph(arguments.after).graph, "after"));
  write_file(arguments.output, svg_of(scenes));
  fmt::print("{}: {} panel{}\n", arguments.output, scenes.size(), scenes.size() == 1 ? "" : "s");
  return kSuccess;
}

}  // namespace

void add_plot(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<PlotArguments>();
  CLI::App* command = app.add_subcommand("plot", "Draws a graph, or two side by side, as an SVG picture");
  command->add_option("BEFORE", arguments->before, "A graph")->required();
  command->add_option("AFTER", arguments->after, "The same graph, optimised");
  command->add_option("-o,--output", arguments->output, "Where to write the picture (.svg)")->required();
  command->callback([&action, arguments] { action = [arguments] { return plot_files(*arguments); }; });
}

}  // namespace boxplus::app
