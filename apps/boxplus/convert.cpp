// SPDX-License-Identifier: BSD-3-Clause
// boxplus convert IN OUT: reads a graph in any known format and writes it in another one.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "command.h"
#include "command_line/message.h"
#include "command_line/option_kinds.h"
#include "files/format_names.h"
#include "files/graph_input.h"
#include "files/outputs.h"

namespace boxplus::app {
namespace {

struct ConvertArguments {
  std::string input, output, format;
  bool quiet = false;
  ReadOptions reading;
};

std::string counted(std::size_t count, const char* singular, const char* plural) {
  return fmt::format("{} {}", count, count == 1 ? singular : plural);
}

std::string summary(const GraphFile& file) {
  std::string text = counted(file.graph.vertex_count(), "vertex", "vertices") + ", " +
                     counted(file.graph.edge_count(), "edge", "edges");
  if (file.graph.parameter_count() > 0)
    text += ", " + counted(file.graph.parameter_count(), "parameter", "parameters");
  if (!file.kept.empty()) text += ", " + counted(file.kept.size(), "other line", "other lines") + " kept";
  if (file.skipped > 0)
    text += ", " + counted(static_cast<std::size_t>(file.skipped), "line", "lines") + " skipped";
  return text;
}

int convert_file(const ConvertArguments& arguments) {
  const std::vector<Output> outputs{graph_output("OUT", arguments.output, arguments.input)};
  if (arguments.format.empty()) require_writable_format(arguments.output);
  check_outputs(outputs);
  const GraphFile file = load_graph(arguments.input, arguments.reading);
  save_graph(arguments.output, file, format_name(arguments.format));
  if (!arguments.quiet) {
    print_summary(outputs, fmt::format("{} → {}: {}\n", escaped(input_name(arguments.input)),
                                       escaped(output_name(arguments.output)), summary(file)));
  }
  return kSuccess;
}

}  // namespace

void add_convert(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<ConvertArguments>();
  CLI::App* command =
      app.add_subcommand("convert", "Writes a graph in another format, with its vertices sorted by id");
  command->add_option("IN", arguments->input, graph_to_read())->required()->check(file_name());
  command
      ->add_option("OUT", arguments->output,
                   fmt::format("Where to write the graph ({}); - is standard output", writable_formats()))
      ->required()
      ->check(file_name());
  command
      ->add_option("--format", arguments->format,
                   "The format to write; by default, the extension of OUT selects it")
      ->type_name("FORMAT")
      ->check(one_of(writable_names()))
      ->group("Output");
  command->add_flag("-q,--quiet", arguments->quiet, "Do not print a summary of the conversion")
      ->group("Output");
  add_reading_options(*command, arguments->reading);
  command->footer(
      "Examples:\n"
      "  boxplus convert w10000.graph w10000.g2o\n"
      "  boxplus convert sparse/0 text --format colmap-text\n"
      "  boxplus convert sparse/0 points.ply\n"
      "  boxplus convert old.g2o - --rename VERTEX_CAM=VERTEX_SE3:QUAT | boxplus info -");
  command->callback([&action, arguments] { action = [arguments] { return convert_file(*arguments); }; });
}

}  // namespace boxplus::app
