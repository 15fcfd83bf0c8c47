// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/optimize_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "boxplus/optimize/algorithm_table.h"
#include "boxplus/optimize/start_table.h"
#include "command_line/option_kinds.h"
#include "files/format_names.h"
#include "files/graph_input.h"
#include "optimize/kernel_name.h"

namespace boxplus::app {
namespace {

Choices<Start> start_choices() {
  Choices<Start> choices;
  for (const detail::StartEntry& entry : detail::start_table()) choices.emplace_back(entry.name, entry.start);
  return choices;
}

Choices<AlgorithmKind> algorithm_choices() {
  Choices<AlgorithmKind> choices;
  for (const detail::AlgorithmEntry& entry : detail::algorithm_table())
    choices.emplace_back(entry.name, entry.kind);
  return choices;
}

const Choices<LinearSolverKind> kSolvers{{"automatic", LinearSolverKind::kAutomatic},
                                         {"cholesky", LinearSolverKind::kBlockCholesky},
                                         {"pcg", LinearSolverKind::kPcg},
                                         {"dense", LinearSolverKind::kDense},
                                         {"eigen", LinearSolverKind::kEigenSparse}};
const Choices<GaugePolicy> kGauges{
    {"fix-first", GaugePolicy::kFixFirst}, {"damp", GaugePolicy::kDamp}, {"error", GaugePolicy::kError}};
const Choices<DampingScale> kDampings{{"identity", DampingScale::kIdentity},
                                      {"diagonal", DampingScale::kDiagonal}};
const Choices<Precision> kPrecisions{
    {"automatic", Precision::kAutomatic}, {"double", Precision::kDouble}, {"mixed", Precision::kMixed}};
const Choices<KernelScope> kScopes{{"all", KernelScope::kAll}, {"loop-closures", KernelScope::kLoopClosures}};

void add_output_options(CLI::App& command, OptimizeArguments& arguments) {
  command.add_option("FILE", arguments.input, graph_to_read())->required()->check(file_name());
  command
      .add_option("-o,--output", arguments.output,
                  fmt::format("Where to write the optimised graph ({}); - is stdout", writable_formats()))
      ->check(file_name())
      ->type_name("FILE")
      ->group("Output");
  command.add_option("--json", arguments.json, "Where to write the report as JSON; - is stdout")
      ->check(file_name())
      ->type_name("FILE")
      ->group("Output");
  CLI::Option* quiet =
      command.add_flag("-q,--quiet", arguments.quiet, "No report and no progress; messages only")
          ->group("Output");
  command.add_flag("-v,--verbose", arguments.verbose, "One line per iteration, on stderr")
      ->group("Output")
      ->excludes(quiet);
}

void add_method_options(CLI::App& command, OptimizeArguments& arguments) {
  Options& options = arguments.options;
  add_choice(
      command, "--start", options.start, start_choices(),
      "Where to begin; automatic keeps the file's estimates where their first step does what the linear "
      "model promises, and else takes the better of them and the chordal guess")
      ->group("Method");
  add_choice(command, "--algorithm", options.algorithm, algorithm_choices(), "How to step")->group("Method");
  add_choice(command, "--solver", options.linear_solver, kSolvers, "What solves the linear systems")
      ->group("Method");
  add_choice(
      command, "--precision", options.precision, kPrecisions,
      "How cholesky factorises; mixed: in float, with solutions refined in double; automatic: whichever is "
      "predicted to be faster, but double for gauss-newton")
      ->group("Method");
  command
      .add_option("--threads", options.threads,
                  "At most so many threads; 0: all. The result is the same to the bit")
      ->check(whole_number_from(0))
      ->type_name("N")
      ->group("Method");
  auto* damping = add_choice(command, "--damping", options.damping, kDampings,
                             "What lambda multiplies, in Levenberg-Marquardt");
  auto* lambda = command.add_option("--lambda", options.initial_lambda,
                                    "The first lambda of Levenberg-Marquardt; without, H tells");
  damping->group("Method");
  lambda->check(number_above(0))->type_name("X")->group("Method");
}

void add_id_option(CLI::App& command, const std::string& name, std::vector<IdRange>& ids,
                   const std::string& text) {
  const auto complaint = [](const std::string& value) {
    try {
      parse_id_ranges(value);
      return std::string();
    } catch (const InvalidArgument& error) {
      return std::string(error.what());
    }
  };
  command
      .add_option_function<std::string>(
          name, [&ids](const std::string& value) { ids = parse_id_ranges(value); }, text)
      ->type_name("ID,ID-ID,...")
      ->check(CLI::Validator(complaint, ""))
      ->join(',')
      ->group("Problem");
}

void add_problem_options(CLI::App& command, OptimizeArguments& arguments) {
  add_choice(command, "--gauge", arguments.options.gauge, kGauges,
             "What to do about a part of the graph that nothing holds in place: hold its first pose, damp "
             "it minutely, or stop with exit code 3")
      ->group("Problem");
  add_id_option(command, "--fix", arguments.fixed, "Keep these vertices where they are, in this run");
  add_id_option(command, "--only-vertices", arguments.moving,
                "Move these vertices only; all others stay where they are");
}

void add_stop_options(CLI::App& command, Options& options) {
  command.add_option("--iterations", options.max_iterations, "Stop after so many iterations")
      ->check(whole_number_from(0))
      ->type_name("N")
      ->capture_default_str()
      ->group("Stop");
  command.add_option("--time-limit", options.time_limit_s, "Stop after so many seconds of optimisation")
      ->check(number_from(0))
      ->type_name("SECONDS")
      ->group("Stop");
  command
      .add_option("--cost-tolerance", options.cost_tolerance,
                  "Converged when chi2 falls by less than this fraction")
      ->check(number_from(0))
      ->type_name("X")
      ->capture_default_str()
      ->group("Stop");
  command
      .add_option("--step-tolerance", options.step_tolerance,
                  "Converged when a step is smaller than this fraction of the run's largest")
      ->check(number_from(0))
      ->type_name("X")
      ->capture_default_str()
      ->group("Stop");
  command
      .add_option("--gradient-tolerance", options.gradient_tolerance,
                  "Converged when no entry of the gradient is larger")
      ->check(number_from(0))
      ->type_name("X")
      ->capture_default_str()
      ->group("Stop");
}

}  // namespace

void add_robust_options(CLI::App& command, KernelArguments& arguments) {
  auto* kernel =
      command
          .add_option(
              "--kernel", arguments.kernel,
              "Robust kernel for the errors, so that outliers count less. Barron takes its shape along: "
              "Barron:-2")
          ->transform(kernel_name())
          ->group("Outliers");
  command
      .add_option("--kernel-width", arguments.kernel_width,
                  "From where errors count less, in standard deviations; for " +
                      kernels_with_squared_width() +
                      " squared. Without, it follows from the rows of each edge, so that 95 % of good errors "
                      "lie within: 1.96 for one row, 2.45 for two, 2.80 for three, 3.55 for six (squared "
                      "for those two)")
      ->check(number_above(0))
      ->type_name("X")
      ->needs(kernel)
      ->group("Outliers");
  add_choice(command, "--kernel-on", arguments.kernel_scope, kScopes,
             "The edges that get it; loop closures join poses that do not follow each other by id")
      ->needs(kernel)
      ->group("Outliers");
}

void add_optimize_options(CLI::App& command, OptimizeArguments& arguments) {
  add_output_options(command, arguments);
  add_method_options(command, arguments);
  add_robust_options(command, arguments);
  add_problem_options(command, arguments);
  add_stop_options(command, arguments.options);
  add_reading_options(command, arguments.reading);
}

}  // namespace boxplus::app
