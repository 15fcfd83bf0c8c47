// SPDX-License-Identifier: BSD-3-Clause
// boxplus info FILE: prints the contents of a graph, and anything unusual about it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <optional>

#include "command.h"
#include "command_line/option_kinds.h"
#include "files/format_names.h"
#include "files/graph_input.h"
#include "files/outputs.h"
#include "info/edge_lines.h"
#include "info/info_text.h"
#include "info/matrix_file.h"
#include "optimize/optimize_options.h"
#include "optimize/optimize_run.h"

namespace boxplus::app {
namespace {

struct InfoArguments : RunSettings {
  std::string input, json, matrix;
  std::size_t worst = 5;
  std::optional<Suspects> suspects;  ///< of --outliers
  bool diagnose = false;
  ReadOptions reading{.indefinite = ReadOptions::Indefinite::kProject};
};

/// Sets the kernel on its edges, and counts the edges that it rejects.
void try_kernel(Graph& graph, const RunSettings& settings, GraphFacts& facts) {
  facts.kernel = set_kernels(graph, settings);
  for (const EdgeRef& edge : graph.all_edges()) {
    if (graph.kernel(edge) != nullptr) facts.rejected += graph.weight(edge) < Report::kRejectedWeight;
  }
}

int describe_file(const InfoArguments& arguments) {
  const std::vector<Output> outputs{{"--json", arguments.json}, {"--matrix", arguments.matrix}};
  for (const Output& output : outputs) refuse_to_replace(output, {arguments.input});
  check_outputs(outputs);
  const std::string text = read_text(arguments.input);
  GraphFile file = parse_input(text, arguments.input, arguments.reading);
  print_notes(file, arguments.input);
  const std::string name = input_name(arguments.input);
  const std::vector<std::int64_t> edge_lines = find_edge_lines(text, file, arguments.reading);
  GraphFacts facts = find_facts(file, edge_lines, arguments.worst);
  facts.keeps_indefinite = arguments.reading.indefinite == ReadOptions::Indefinite::kAsGiven;
  if (arguments.suspects)
    facts.outliers = find_false_edges(file, edge_lines, arguments.options, *arguments.suspects);
  try_kernel(file.graph, arguments, facts);
  if (arguments.diagnose) facts.diagnosis = find_diagnosis(file, edge_lines);
  if (!arguments.matrix.empty()) write_output(arguments.matrix, matrix_text(file.graph, arguments.matrix));
  if (!arguments.json.empty()) write_output(arguments.json, facts_json(facts, file, name));
  if (!takes_stdout(outputs)) fmt::print("{}", facts_text(facts, name));
  return kSuccess;
}

}  // namespace

void add_info(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<InfoArguments>();
  CLI::App* command = app.add_subcommand(
      "info", "Describes a graph: counts, components, degrees, gauge, chi2 by type, worst edges");
  command->add_option("FILE", arguments->input, graph_to_read())->required()->check(file_name());
  command->add_option("--worst", arguments->worst, "List this many edges with the largest chi2")
      ->check(whole_number_from(0))
      ->type_name("N")
      ->capture_default_str()
      ->group("Output");
  command
      ->add_flag("--diagnose", arguments->diagnose, "Also say what is wrong or unusual, and how to mend it")
      ->group("Output");
  command
      ->add_option("--json", arguments->json,
                   "Where to write the result as JSON; - is stdout, and then no text is printed")
      ->check(file_name())
      ->type_name("FILE")
      ->group("Output");
  command
      ->add_option(
          "--matrix", arguments->matrix,
          "Where to write the matrix H of the normal equations: a name with .mtx is Matrix Market, any "
          "other is Octave text")
      ->check(file_name())
      ->type_name("FILE")
      ->group("Output");
  add_robust_options(*command, *arguments);
  add_suspects_option(*command, arguments->suspects,
                      "Say which edges look false, and look for them among the loop closures (edges between "
                      "poses whose ids are not consecutive) or among all edges");
  add_reading_options(*command, arguments->reading);
  command->footer(
      "Examples:\n"
      "  boxplus info graph.g2o\n"
      "  boxplus info graph.g2o --json - | jq .chi2\n"
      "  boxplus info graph.g2o --diagnose\n"
      "  boxplus info graph.g2o --kernel Tukey --kernel-on loop-closures\n"
      "  boxplus info graph.g2o --outliers loop-closures\n"
      "  boxplus info graph.g2o --matrix H.mtx\n"
      "\n"
      "--diagnose examines the estimates of the file: before a run, or the result of a run.\n"
      "docs/diagnosis.md explains each finding.\n"
      "\n"
      "--matrix writes H = JᵀΩJ at the estimates of the file, with the weights of --kernel. Each vertex\n"
      "that is not fixed has a block of rows; comments in the file name its vertex (docs/formats.md).\n"
      "\n"
      "With --kernel, it counts the edges that the kernel rejects at the estimates of the file. chi2 is\n"
      "computed without the kernel.\n"
      "\n"
      "--outliers optimizes a copy of the graph, as boxplus optimize --outliers does, counts the false\n"
      "edges, and lists up to ten of them, those with the largest chi2 first (docs/outliers.md).");
  command->callback([&action, arguments] { action = [arguments] { return describe_file(*arguments); }; });
}

}  // namespace boxplus::app
