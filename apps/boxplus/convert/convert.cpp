// SPDX-License-Identifier: BSD-3-Clause
// boxplus convert IN OUT: reads a graph in any known format and writes it in another one.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "command.h"
#include "command_line/message.h"
#include "command_line/option_kinds.h"
#include "convert/anonymize.h"
#include "convert/segments_to_lines.h"
#include "convert/stereo_to_slam3d.h"
#include "files/format_names.h"
#include "files/graph_input.h"
#include "files/outputs.h"

namespace boxplus::app {
namespace {

/// What other types the elements get.
enum class Change : std::uint8_t { kNone, kSlam3d, kLines };

struct ConvertArguments {
  std::string input, output, format;
  Change change = Change::kNone;
  bool anonymize = false, quiet = false;
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

void change_types(GraphFile& file, Change change) {
  if (change == Change::kSlam3d) stereo_to_slam3d(file);
  if (change == Change::kLines) segments_to_lines(file);
}

int convert_file(const ConvertArguments& arguments) {
  const std::vector<Output> outputs{graph_output("OUT", arguments.output, arguments.input)};
  if (arguments.format.empty()) require_writable_format(arguments.output);
  check_outputs(outputs);
  GraphFile file = load_graph(arguments.input, arguments.reading, arguments.quiet);
  change_types(file, arguments.change);
  const std::size_t anonymized = arguments.anonymize ? anonymize(file) : 0;
  save_graph(arguments.output, file, format_name(arguments.format), arguments.quiet);
  if (!arguments.quiet) {
    std::string text = summary(file);
    if (arguments.anonymize) text += ", " + counted(anonymized, "edge", "edges") + " anonymized";
    print_summary(outputs, fmt::format("{} → {}: {}\n", escaped(input_name(arguments.input)),
                                       escaped(output_name(arguments.output)), text));
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
  const Choices<Change> changes = {
      {"same", Change::kNone}, {"slam3d", Change::kSlam3d}, {"lines", Change::kLines}};
  add_choice(
      *command, "--to", arguments->change, changes,
      "The types of the elements: the same; with stereo cameras (VERTEX_CAM) as poses with a camera; or "
      "with segments (VERTEX_SEGMENT2D) as infinite lines")
      ->group("Changes");
  command
      ->add_flag(
          "--anonymize", arguments->anonymize,
          "Remove the data association: landmarks, and poses to which loops are closed, become the vertex "
          "-1 in their edges")
      ->group("Changes");
  command->add_flag("-q,--quiet", arguments->quiet, "Do not print a summary of the conversion")
      ->group("Output");
  add_reading_options(*command, arguments->reading);
  command->footer(
      "Examples:\n"
      "  boxplus convert w10000.graph w10000.g2o\n"
      "  boxplus convert sparse/0 text --format colmap-text\n"
      "  boxplus convert sparse/0 points.ply\n"
      "  boxplus convert log.clf log.g2o\n"
      "  boxplus convert stereo.g2o poses.g2o --to slam3d\n"
      "  boxplus convert old.g2o - --rename VERTEX_POSE3=VERTEX_SE3:QUAT | boxplus info -");
  command->callback([&action, arguments] { action = [arguments] { return convert_file(*arguments); }; });
}

}  // namespace boxplus::app
