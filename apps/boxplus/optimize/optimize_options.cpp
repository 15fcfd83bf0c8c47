// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/optimize_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "boxplus/linear/linear_solver_table.h"
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

Choices<LinearSolverKind> solver_choices() {
  Choices<LinearSolverKind> choices;
  for (const detail::LinearSolverEntry& entry : detail::linear_solver_table())
    choices.emplace_back(entry.option, entry.kind);
  return choices;
}

const Choices<GaugePolicy> kGauges{
    {"fix-first", GaugePolicy::kFixFirst}, {"damp", GaugePolicy::kDamp}, {"error", GaugePolicy::kError}};
const Choices<Options::DampingScale> kDampings{{"identity", Options::DampingScale::kIdentity},
                                               {"diagonal", Options::DampingScale::kDiagonal}};
const Choices<Precision> kPrecisions{
    {"automatic", Precision::kAutomatic}, {"double", Precision::kDouble}, {"mixed", Precision::kMixed}};
const Choices<KernelScope> kScopes{{"all", KernelScope::kAll}, {"loop-closures", KernelScope::kLoopClosures}};

void add_output_options(CLI::App& command, OptimizeArguments& arguments) {
  command.add_option("FILE", arguments.input, graph_to_read())->required()->check(file_name());
  command
      .add_option("-o,--output", arguments.output,
                  fmt::format("Where to write the optimized graph ({}); - is stdout", writable_formats()))
      ->check(file_name())
      ->type_name("FILE")
      ->group("Output");
  command.add_option("--json", arguments.json, "Where to write the report as JSON; - is stdout")
      ->check(file_name())
      ->type_name("FILE")
      ->group("Output");
  CLI::Option* quiet =
      command.add_flag("-q,--quiet", arguments.quiet, "Print no report and no progress, only messages")
          ->group("Output");
  command.add_flag("-v,--verbose", arguments.verbose, "Print one line per iteration to stderr")
      ->group("Output")
      ->excludes(quiet);
}

void add_method_options(CLI::App& command, OptimizeArguments& arguments) {
  Options& options = arguments.options;
  add_choice(
      command, "--start", options.start, start_choices(),
      "The initial estimates; automatic: keep the estimates of the file if there is no --kernel and the "
      "first "
      "step reduces chi2 as the linear model predicts, and otherwise use either these estimates or the "
      "chordal guess, whichever is better")
      ->group("Method");
  add_choice(command, "--algorithm", options.algorithm, algorithm_choices(), "The optimization algorithm")
      ->group("Method");
  add_choice(command, "--solver", options.linear_solver, solver_choices(), "The linear solver")
      ->group("Method");
  add_choice(
      command, "--precision", options.precision, kPrecisions,
      "The precision of the cholesky solver; mixed: factorize in float and refine the solutions in double; "
      "automatic: whichever is predicted to be faster, but always double for gauss-newton")
      ->group("Method");
  command
      .add_option(
          "--threads", options.threads,
          "Use at most this many threads; 0: one per hardware thread. Results do not depend on this number")
      ->check(whole_number_from(0))
      ->type_name("N")
      ->group("Method");
  auto* damping = add_choice(
      command, "--damping", options.damping, kDampings,
      "The matrix that Levenberg-Marquardt multiplies by lambda and adds to H: identity or diagonal of H");
  auto* lambda =
      command.add_option("--lambda", options.initial_lambda,
                         "The initial lambda of Levenberg-Marquardt; by default, it is computed from H");
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
             "How to treat a part of the graph that nothing holds in place; fix-first: fix its first pose; "
             "damp: add minimal damping; error: stop with exit code 3")
      ->group("Problem");
  add_id_option(command, "--fix", arguments.fixed,
                "Hold these vertices fixed in this run; the output file does not mark them as fixed");
  add_id_option(command, "--only-vertices", arguments.moving,
                "Move only these vertices; all others keep their estimates");
}

void add_stop_options(CLI::App& command, Options& options) {
  command.add_option("--iterations", options.max_iterations, "Stop after this many iterations")
      ->check(whole_number_from(0))
      ->type_name("N")
      ->capture_default_str()
      ->group("Stop");
  command.add_option("--time-limit", options.time_limit_s, "Stop after this many seconds of optimization")
      ->check(number_from(0))
      ->type_name("SECONDS")
      ->group("Stop");
  command
      .add_option("--cost-tolerance", options.cost_tolerance,
                  "Converged if a step reduces chi2 by less than this fraction")
      ->check(number_from(0))
      ->type_name("X")
      ->capture_default_str()
      ->group("Stop");
  command
      .add_option("--step-tolerance", options.step_tolerance,
                  "Converged if no entry of a step is larger than this fraction of its standard deviation")
      ->check(number_from(0))
      ->type_name("X")
      ->capture_default_str()
      ->group("Stop");
  command
      .add_option("--gradient-tolerance", options.gradient_tolerance,
                  "Converged if no entry of the gradient is larger than this")
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
              "Robust kernel, which gives less weight to outliers. For Barron, the name contains the shape: "
              "Barron:-2")
          ->transform(kernel_name())
          ->group("Outliers");
  command
      .add_option("--kernel-width", arguments.kernel_width,
                  "The error, in standard deviations, above which the kernel reduces weights; for " +
                      kernels_with_squared_width() +
                      ", the square of this error. The default is above 95 % of the errors of inliers: 1.96 "
                      "for errors with one row, 2.45 for two rows, 2.80 for three, 3.55 for six (or the "
                      "squares of these numbers)")
      ->check(number_above(0))
      ->type_name("X")
      ->needs(kernel)
      ->group("Outliers");
  add_choice(
      command, "--kernel-on", arguments.kernel_scope, kScopes,
      "The edges that get the kernel; loop closures are edges between poses whose ids are not consecutive")
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
