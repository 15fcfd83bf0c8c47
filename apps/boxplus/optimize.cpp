// SPDX-License-Identifier: BSD-3-Clause
// boxplus optimize FILE: reads a graph, optimises it, reports, writes.
#include "boxplus/optimize/optimize.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <memory>

#include "boxplus/robust/make_robust_kernel.h"
#include "command.h"
#include "edge_roles.h"
#include "graph_input.h"
#include "interrupt.h"
#include "message.h"
#include "optimize_options.h"
#include "outputs.h"
#include "progress.h"
#include "report_json.h"

namespace boxplus::app {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

std::vector<Output> outputs_of(const OptimizeArguments& arguments) {
  return {{"--output", arguments.output}, {"--json", arguments.json}};
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

void require_levenberg_marquardt(const CLI::App& command, const OptimizeArguments& arguments) {
  if (arguments.options.algorithm == AlgorithmKind::kLevenbergMarquardt) return;
  for (const char* option : {"--damping", "--lambda"}) {
    if (command.count(option) > 0) {
      throw CLI::RequiresError(option, "--algorithm levenberg-marquardt");
    }
  }
}

/// Gives the chosen edges the kernel; tells how many.
KernelFacts robustify(Graph& graph, const OptimizeArguments& arguments) {
  KernelFacts facts;
  if (arguments.kernel.empty()) return facts;
  facts.name = arguments.kernel;
  facts.width = arguments.kernel_width;
  const std::shared_ptr<const RobustKernel> kernel =
      make_robust_kernel(arguments.kernel, arguments.kernel_width);
  const EdgeRoles role(graph);
  for (const EdgeRef& edge : graph.all_edges()) {
    if (arguments.kernel_scope == KernelScope::kAll || role(edge) == EdgeRole::kLoopClosure) {
      graph.set_kernel(edge, kernel);
      ++facts.edges;
    }
  }
  if (facts.edges == 0) print_message("the graph has no loop closures: the kernel is used nowhere");
  return facts;
}

/// Fixes vertices for one run: what the file says about them stays.
class FixForRun {
 public:
  FixForRun(Graph& graph, const std::vector<VertexRef>& vertices) : graph_(graph) {
    for (const VertexRef& vertex : vertices) {
      if (graph.is_fixed(vertex)) continue;
      graph.fix(vertex);
      fixed_.push_back(vertex);
    }
  }
  ~FixForRun() {
    for (const VertexRef& vertex : fixed_) graph_.unfix(vertex);
  }
  FixForRun(const FixForRun&) = delete;
  FixForRun& operator=(const FixForRun&) = delete;

 private:
  Graph& graph_;
  std::vector<VertexRef> fixed_;
};

Report run(Graph& graph, const OptimizeArguments& arguments, Progress& progress) {
  Options options = arguments.options;
  options.vertices = find_vertices(graph, arguments.moving, "--only-vertices");
  options.stop = Interrupt::flag();
  options.callback = [&progress](const IterationRecord& record) {
    progress.iteration(record);
    return true;
  };
  const FixForRun fixed(graph, find_vertices(graph, arguments.fixed, "--fix"));
  progress.stage("preparing …");
  Report report = optimize(graph, options);
  progress.erase();
  return report;
}

std::string where_written(const OptimizeArguments& arguments) {
  return arguments.output.empty()              ? "not written (-o FILE writes it)"
         : arguments.output == kStandardStream ? "written to the standard output"
                                               : "written to " + arguments.output;
}

void print_report(const Report& report, const RunFacts& facts, const OptimizeArguments& arguments) {
  std::string text = to_string(report);
  if (!facts.kernel.name.empty()) {
    text += fmt::format(
        "\n{} kernel of width {:g} on {} of {} edges; chi2 is the sum of what the kernels make of it.\n",
        facts.kernel.name, facts.kernel.width, facts.kernel.edges, facts.edges);
  }
  text += fmt::format("\nThe optimised graph is {}.\n", escaped(where_written(arguments)));
  fmt::print(takes_stdout(outputs_of(arguments)) ? stderr : stdout, "{}", text);
}

void print_why_stopped(const Report& report, const OptimizeArguments& arguments) {
  if (report.converged()) return;
  if (report.reason == Reason::kStopFlag) {
    print_message(fmt::format("{}: interrupted after {} iteration{}; the best estimate is {}",
                              input_name(arguments.input), report.iterations,
                              report.iterations == 1 ? "" : "s", where_written(arguments)));
  } else {
    print_message(fmt::format("{}: {}", input_name(arguments.input), report.message));
  }
}

int optimize_file(const OptimizeArguments& arguments) {
  check_outputs(outputs_of(arguments));
  const auto begin = Clock::now();
  Progress progress(choose_progress(arguments.quiet, arguments.verbose));
  progress.stage(fmt::format("reading {} …", input_name(arguments.input)));
  const std::string text = read_text(arguments.input);
  progress.erase();
  GraphFile file = load_graph_text(text, arguments.input, arguments.reading);
  RunFacts facts;
  facts.input = input_name(arguments.input);
  facts.edges = file.graph.edge_count();
  facts.load_s = seconds_since(begin);
  facts.kernel = robustify(file.graph, arguments);

  const Interrupt interrupt;
  const Report report = run(file.graph, arguments, progress);
  if (!arguments.output.empty()) save_graph(arguments.output, file);
  facts.total_s = seconds_since(begin);
  if (!arguments.json.empty()) write_output(arguments.json, report_json(report, facts));
  if (!arguments.quiet) print_report(report, facts, arguments);
  print_why_stopped(report, arguments);
  return exit_code(report.status);
}

}  // namespace

void add_optimize(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<OptimizeArguments>();
  CLI::App* command =
      app.add_subcommand("optimize", "Moves the vertices of a graph to where they explain its edges best");
  add_optimize_options(*command, *arguments);
  command->footer(
      "Examples:\n"
      "  boxplus optimize graph.g2o -o optimized.g2o\n"
      "  boxplus optimize graph.g2o -o robust.g2o --kernel Cauchy --kernel-on loop-closures\n"
      "\n"
      "Ctrl-C stops at the next chance: the best estimate so far is written, and the exit code is 1.\n"
      "A second Ctrl-C ends at once.");
  command->callback([&action, command, arguments] {
    require_levenberg_marquardt(*command, *arguments);
    action = [arguments] { return optimize_file(*arguments); };
  });
}

}  // namespace boxplus::app
