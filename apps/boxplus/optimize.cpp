// SPDX-License-Identifier: BSD-3-Clause
// boxplus optimize FILE: reads a graph, optimises it, reports, writes.
#include "boxplus/optimize/optimize.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <map>
#include <memory>

#include "boxplus/base/error.h"
#include "boxplus/io/graph_file.h"
#include "command.h"
#include "report_json.h"

namespace boxplus::app {
namespace {

struct OptimizeArguments {
  std::string input, output, json, start = "automatic", algorithm = "automatic";
  bool quiet = false, lenient = false;
  Options options;
};

const std::map<std::string, Start> kStarts{{"automatic", Start::kAutomatic},
                                           {"current", Start::kCurrent},
                                           {"odometry", Start::kOdometry},
                                           {"spanning-tree", Start::kSpanningTree},
                                           {"chordal", Start::kChordal}};
const std::map<std::string, AlgorithmKind> kAlgorithms{
    {"automatic", AlgorithmKind::kAutomatic},
    {"gauss-newton", AlgorithmKind::kGaussNewton},
    {"levenberg-marquardt", AlgorithmKind::kLevenbergMarquardt},
    {"dogleg", AlgorithmKind::kDogleg}};

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void print_notes(const GraphFile& file, const std::string& path) {
  for (const GraphFile::Note& note : file.notes) {
    if (note.line > 0) {
      fmt::print(stderr, "boxplus: {}:{}: {}\n", path, note.line, note.text);
    } else {
      fmt::print(stderr, "boxplus: {}: {}\n", path, note.text);
    }
  }
}

int exit_code(Status status) {
  switch (status) {
    case Status::kConverged:
      return kSuccess;
    case Status::kNotConverged:
      return kNotConverged;
    default:
      return kNumericalFailure;
  }
}

int optimize_file(const OptimizeArguments& arguments) {
  const auto begin = std::chrono::steady_clock::now();
  RunFacts facts;
  facts.input = arguments.input;
  ReadOptions reading;
  reading.lenient = arguments.lenient;
  GraphFile file = read_graph(arguments.input, reading);
  facts.load_s = seconds_since(begin);
  print_notes(file, arguments.input);
  if (file.graph.vertex_count() == 0 && file.graph.edge_count() == 0) {
    throw FileError(arguments.input + ": holds no vertex and no edge that boxplus knows");
  }

  Options options = arguments.options;
  options.start = kStarts.at(arguments.start);
  options.algorithm = kAlgorithms.at(arguments.algorithm);
  const Report report = optimize(file.graph, options);
  if (!arguments.output.empty()) write_graph(arguments.output, file);
  facts.total_s = seconds_since(begin);
  if (!arguments.json.empty()) write_file(arguments.json, report_json(report, facts));
  if (!arguments.quiet) fmt::print("{}", to_string(report));
  if (!report.converged()) fmt::print(stderr, "boxplus: {}: {}\n", arguments.input, report.message);
  return exit_code(report.status);
}

}  // namespace

void add_optimize(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<OptimizeArguments>();
  CLI::App* command =
      app.add_subcommand("optimize", "Moves the vertices of a graph to where they explain its edges best");
  command->add_option("FILE", arguments->input, "A .g2o file, or a TORO .graph file")->required();
  command->add_option("-o,--output", arguments->output, "Where to write the optimised graph (.g2o)");
  command->add_option("--json", arguments->json, "Where to write the report as JSON");
  command->add_flag("-q,--quiet", arguments->quiet, "Do not print the report");
  command->add_flag("--lenient", arguments->lenient, "Skip and count lines that cannot be read");
  command
      ->add_option("--threads", arguments->options.threads,
                   "At most so many threads; 0: all. Results do not change")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--iterations", arguments->options.max_iterations, "At most so many iterations")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command
      ->add_option("--start", arguments->start, "Where to begin (automatic: the better of file and chordal)")
      ->check(CLI::IsMember(kStarts))
      ->capture_default_str();
  command->add_option("--algorithm", arguments->algorithm, "How to step")
      ->check(CLI::IsMember(kAlgorithms))
      ->capture_default_str();
  command->callback([&action, arguments] { action = [arguments] { return optimize_file(*arguments); }; });
}

}  // namespace boxplus::app
