// SPDX-License-Identifier: BSD-3-Clause
// boxplus optimize FILE: reads a graph, optimizes it, prints a report and writes the optimized graph.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <exception>
#include <memory>
#include <optional>
#include <string>

#include "boxplus/base/error.h"
#include "command.h"
#include "command_line/message.h"
#include "command_line/progress.h"
#include "files/graph_input.h"
#include "files/interrupt.h"
#include "files/outputs.h"
#include "io/model/graph_model.h"
#include "optimize/optimize_options.h"
#include "optimize/optimize_report.h"
#include "optimize/optimize_run.h"
#include "optimize/outlier_search.h"
#include "optimize/petsc_plugin.h"
#include "optimize/report_json.h"
#include "optimize/run_steps.h"
#include "view/live_view.h"

namespace boxplus::app {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Certifies a converged result, and the better one if there is one.
void certify_result(Graph& graph, const OptimizeArguments& arguments, const Report& report, RunFacts& facts,
                    Progress& progress) {
  if (!arguments.certify || !report.converged()) return;
  facts.certificate = run_certify(graph, arguments, report.time.total_s, progress);
  if (facts.certificate->verdict != Certificate::Verdict::kLocalMinimum) return;
  const double spent_s = report.time.total_s + facts.certificate->time_s;
  facts.of_better = run_certify(graph, arguments, spent_s, progress);
}

void note_priors(const PositionPriors& priors, const std::string& path) {
  if (priors.far > 0)
    print_message(fmt::format("{}: {} position{} far from the model; --kernel gives them less weight",
                              input_name(path), priors.far, priors.far == 1 ? " is" : "s are"));
  if (priors.others == 0) return;
  print_message(fmt::format("{}: {} row{} no image of the graph", input_name(path), priors.others,
                            priors.others == 1 ? " names" : "s name"));
}

int optimize_file(OptimizeArguments arguments) {
  check_outputs(outputs_of(arguments));
  if (arguments.petsc) arguments.options.custom_linear_solver = load_petsc_solver(*arguments.petsc);
  refuse_to_replace({"--json", arguments.json}, {arguments.input});
  refuse_to_replace({"--write-outliers", arguments.outlier_list}, {arguments.input});
  const auto begin = Clock::now();
  Progress progress(choose_progress(arguments.quiet, arguments.verbose));
  progress.stage(fmt::format("reading {} …", input_name(arguments.input)));
  ReadOptions reading = arguments.reading;
  reading.threads = arguments.options.threads;
  GraphFile file = read_input(arguments.input, reading, true);
  progress.erase();
  print_notes(file, arguments.input);
  require_edges(file, arguments.input);
  require_representable(arguments.output, file);
  if (arguments.certify) require_certifiable(file.graph, arguments);
  RunFacts facts;
  facts.input = input_name(arguments.input);
  facts.edges = file.graph.edge_count();
  facts.skipped_lines = file.skipped;
  facts.indefinite_edges = file.indefinite;
  facts.load_s = seconds_since(begin);
  set_pixel_sigma(file.graph, arguments);
  if (!arguments.position_priors.empty()) {
    facts.priors = add_position_priors(file, arguments.position_priors);
    note_priors(*facts.priors, arguments.position_priors);
  }
  facts.kernel = set_kernels(file.graph, arguments);

  const Interrupt interrupt;
  std::optional<LiveView> view;
  if (arguments.view) view.emplace(file, arguments.input, arguments);
  if (arguments.suspects) facts.outliers = run_find_outliers(file.graph, arguments, progress);
  Report report = facts.outliers ? facts.outliers->report
                                 : run_optimize(file.graph, arguments, progress, view ? &*view : nullptr);
  if (file.indefinite > 0 && arguments.reading.indefinite == ReadOptions::Indefinite::kAsGiven)
    doubt_indefinite(file.graph, arguments, report);
  certify_result(file.graph, arguments, report, facts, progress);
  if (arguments.remove_outliers && facts.outliers) remove_outliers(file.graph, *facts.outliers);
  if (!arguments.output.empty()) forget_reprojection_errors(file);
  const std::exception_ptr refusal = arguments.output.empty() ? nullptr : save_result(arguments, file, facts);
  facts.total_s = seconds_since(begin);
  if (!arguments.json.empty()) write_output(arguments.json, report_json(report, facts));
  if (!arguments.outlier_list.empty()) {
    write_output(arguments.outlier_list, facts.outliers ? outliers_list(*facts.outliers) : std::string());
  }
  if (!arguments.quiet) print_report(report, facts, arguments);
  print_why_stopped(report, facts, arguments);
  if (refusal) std::rethrow_exception(refusal);
  // Ctrl-C may have ended the certificate.
  const bool is_cut_short = report.converged() && Interrupt::flag()->load();
  if (view) view->serve(report, exit_code(report.status));
  return is_cut_short ? kNotConverged : exit_code(report.status);
}

}  // namespace

void add_optimize(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<OptimizeArguments>();
  CLI::App* command =
      app.add_subcommand("optimize", "Moves the vertices of a graph to minimize the errors of its edges");
  add_optimize_options(*command, *arguments);
  command->footer(
      "Examples:\n"
      "  boxplus optimize graph.g2o -o optimized.g2o\n"
      "  boxplus optimize graph.g2o -o robust.g2o --kernel Cauchy --kernel-on loop-closures\n"
      "  boxplus optimize graph.g2o -o clean.g2o --outliers loop-closures --remove-outliers\n"
      "  boxplus optimize graph.g2o -o optimized.g2o --certify\n"
      "  boxplus optimize scene.bal -o clean.bal --outliers all --remove-outliers\n"
      "\n"
      "Exit codes: 0 converged, 1 not converged, 2 bad input or usage, 3 numerical failure.\n"
      "Ctrl-C stops as soon as possible, writes the best estimate so far, and exits with code 1.\n"
      "A second Ctrl-C ends the command at once.");
  command->callback([&action, command, arguments] {
    require_needed_values(*command);
    action = [arguments] { return optimize_file(*arguments); };
  });
}

}  // namespace boxplus::app
