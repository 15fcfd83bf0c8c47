// SPDX-License-Identifier: BSD-3-Clause
// boxplus plot BEFORE [AFTER] -o PICTURE: draws graphs side by side, or makes a page of one graph.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "boxplus/base/error.h"
#include "command.h"
#include "command_line/message.h"
#include "files/graph_input.h"
#include "files/outputs.h"
#include "optimize/optimize_run.h"
#include "plot/attached_data.h"
#include "plot/bundle_scene.h"
#include "plot/ellipses.h"
#include "plot/error_chart.h"
#include "plot/graph_page.h"
#include "plot/plot_options.h"
#include "plot/truth.h"
#include "view/serving.h"
#include "viewer/scene/bundle_view.h"

namespace boxplus::app {
namespace {

constexpr const char* kPlotFooter =
    "The trajectory connects the poses in the order of their ids. The colors of loop closures and\n"
    "observations show their chi2 per row: gray up to 1, because noise explains such values, and darker\n"
    "for larger values. Both panels have the same color scale.\n"
    "Graph files do not contain robust kernels. After a robust run, repeat the options --kernel and\n"
    "--kernel-width of optimize, so that the colors show chi2 after the kernel.\n"
    "Graphs in space are drawn in parallel projection.\n"
    "In bundle adjustment, cameras are drawn as pyramids, and the colors of points show the mean chi2 per\n"
    "row of their observations. The picture is turned so that the cameras on average look away from the\n"
    "viewer, and shows most points; points far away are left out and counted.\n"
    "Lines of data in a .g2o file belong to the vertex before them. The points that lasers have hit\n"
    "(ROBOTLASER1, RAWLASER1), names (VERTEX_TAG) and 95 % ellipses (VERTEX_ELLIPSE) are drawn at\n"
    "its estimate.\n"
    "Ellipses show the covariances at the estimates, relative to the fixed vertex or, if no vertex is\n"
    "fixed, to the first pose. Ellipses that overlap others or are too small to see are left out.\n"
    "A page (.html) is what boxplus view shows, as one file that needs no server: one can turn the graph,\n"
    "choose colors and sizes, and save pictures, but not optimize.\n"
    "\n"
    "Examples:\n"
    "  boxplus simulate streets -o before.g2o --truth truth.g2o\n"
    "  boxplus optimize before.g2o -o after.g2o\n"
    "  boxplus plot before.g2o after.g2o -o streets.svg --truth truth.g2o\n"
    "  boxplus plot sparse/0 sparse/1 -o errors.svg --reprojection-errors\n"
    "  boxplus plot after.g2o -o figure.pdf --bare --axes --size 252x200 --font-size 7\n"
    "  boxplus plot after.g2o -o graph.html";

struct Input {
  std::string name;   ///< the name of the file, for messages
  std::string title;  ///< of its panel
  GraphFile file;
};

std::string title_of(const std::string& path) {
  if (path == kStandardStream) return "graph";
  const std::filesystem::path file(path);
  return (file.has_filename() ? file : file.parent_path()).stem().string();
}

Input read(const std::string& path, std::string title, const PlotArguments& arguments) {
  Input input{input_name(path), std::move(title), load_graph(path, arguments.reading)};
  set_kernels(input.file.graph, arguments.kernel);
  return input;
}

std::vector<Input> read_inputs(const PlotArguments& arguments) {
  const bool compares = !arguments.after.empty();
  std::vector<Input> inputs;
  inputs.push_back(read(arguments.before, compares ? "before" : title_of(arguments.before), arguments));
  if (compares) inputs.push_back(read(arguments.after, "after", arguments));
  return inputs;
}

Scene scene_of(const Input& input, const View& view, const TruePlaces& truth) {
  const Graph& graph = input.file.graph;
  Scene scene = viewer::is_bundle(graph) ? make_bundle_scene(graph, input.title, view, truth)
                                         : make_scene(graph, input.title, view, truth);
  if (scene.poses + scene.landmark_count == 0)
    throw FileError(input.name + ": expected poses or points to draw, found none with a finite position");
  if (scene.hidden > 0) {
    print_message(fmt::format("{}: {} {} too far away to be drawn", input.name, scene.hidden,
                              scene.hidden == 1 ? "vertex is" : "vertices are"));
  }
  return scene;
}

void check_files(const PlotArguments& arguments) {
  const std::vector<std::string> inputs{arguments.before, arguments.after, arguments.truth};
  if (std::count(inputs.begin(), inputs.end(), kStandardStream) > 1)
    throw InvalidArgument("plot: expected at most one graph from standard input, got '-' twice");
  check_outputs({{"--output", arguments.output}});
  refuse_to_replace({"--output", arguments.output}, inputs);
}

std::string picture_of_graphs(const std::vector<Input>& inputs, const PlotArguments& arguments,
                              PictureFormat format) {
  const Input& last = inputs.back();
  View view = arguments.view;
  if (viewer::is_bundle(last.file.graph)) view.leveling = viewer::leveling(last.file.graph);
  TruePlaces truth;
  if (!arguments.truth.empty()) truth = true_places(last.file, last.name, arguments.truth, arguments.reading);
  std::vector<Scene> scenes;
  for (const Input& input : inputs) scenes.push_back(scene_of(input, view, truth));
  if (arguments.has_ellipses) add_ellipses(scenes.back(), last.file.graph, view, last.name);
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    if (!scenes[i].is_bundle)
      add_data(scenes[i], inputs[i].file, view, inputs[i].name, arguments.reading.lenient);
  }
  return draw_picture(std::move(scenes), view, arguments.picture, format, arguments.resolution);
}

std::string picture_of_errors(const std::vector<Input>& inputs, const PlotArguments& arguments,
                              PictureFormat format) {
  std::vector<ErrorChart> charts;
  for (const Input& input : inputs) {
    if (!viewer::is_bundle(input.file.graph)) {
      throw FileError(input.name +
                      ": expected a graph of bundle adjustment (all edges are reprojection errors) for "
                      "--reprojection-errors, got another one");
    }
    charts.push_back(make_error_chart(input.file.graph, input.title));
  }
  return draw_error_charts(std::move(charts), arguments.picture, format, arguments.resolution);
}

std::string make_picture(const PlotArguments& arguments, PictureFormat format) {
  const std::vector<Input> inputs = read_inputs(arguments);
  return arguments.has_error_chart ? picture_of_errors(inputs, arguments, format)
                                   : picture_of_graphs(inputs, arguments, format);
}

std::string make_page(const PlotArguments& arguments) {
  GraphFile file = load_graph(arguments.before, arguments.reading);
  set_kernels(file.graph, arguments.kernel);
  return make_graph_page(std::move(file), shown_name(arguments.before));
}

int plot_files(const PlotArguments& arguments, const CLI::App& command) {
  const PlotFormat format = format_of(arguments);
  if (!format) refuse_options_of_pictures(command);
  check_files(arguments);
  const std::string output = format ? make_picture(arguments, *format) : make_page(arguments);
  write_output(arguments.output, output);
  if (arguments.output != kStandardStream) {
    fmt::print("{}: {}, {} kB\n", escaped(arguments.output),
               arguments.after.empty() ? "one graph" : "before and after", (output.size() + 999) / 1000);
  }
  return kSuccess;
}

}  // namespace

void add_plot(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<PlotArguments>();
  CLI::App* command = app.add_subcommand(
      "plot",
      "Draws one graph, or two graphs side by side, as an SVG, PDF or PNG picture; or one graph as a page");
  add_plot_options(*command, *arguments);
  command->footer(kPlotFooter);
  command->callback([&action, arguments, command] {
    action = [arguments, command] { return plot_files(*arguments, *command); };
  });
}

}  // namespace boxplus::app
