// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/optimize_report.h"

#include <fmt/format.h>

#include <cstdio>

#include "command_line/message.h"
#include "files/graph_input.h"
#include "optimize/outlier_search.h"

namespace boxplus::app {
namespace {

std::string where_written(const OptimizeArguments& arguments, const RunFacts& facts) {
  return arguments.output.empty()              ? "not written (use -o FILE)"
         : facts.output.empty()                ? "not written"
         : arguments.output == kStandardStream ? "written to standard output"
                                               : "written to " + facts.output;
}

/// Returns " of width 2", or " of width 1.96 (1 row), 2.795 (3 rows)".
std::string widths_text(const KernelFacts& kernel) {
  if (kernel.width) return fmt::format(" of width {:g}", *kernel.width);
  std::string text;
  for (const auto& [rows, width] : kernel.widths) {
    text += fmt::format("{}{:.4g} ({} row{})", text.empty() ? " of width " : ", ", width, rows,
                        rows == 1 ? "" : "s");
  }
  return text;
}

}  // namespace

std::string kernel_text(const KernelFacts& kernel, std::size_t edges) {
  return fmt::format("{} kernel{} on {} of {} edges", kernel.name, widths_text(kernel), kernel.edges, edges);
}

std::vector<Output> outputs_of(const OptimizeArguments& arguments) {
  return {graph_output("--output", arguments.output, arguments.input),
          {"--json", arguments.json},
          {"--write-outliers", arguments.outlier_list}};
}

void print_report(const Report& report, const RunFacts& facts, const OptimizeArguments& arguments) {
  std::string text = to_string(report);
  if (!facts.kernel.name.empty()) {
    text += fmt::format("\n{}; chi2 is computed with the kernel.\n", kernel_text(facts.kernel, facts.edges));
  }
  if (facts.outliers) text += "\n" + outliers_text(*facts.outliers);
  if (arguments.certify && !facts.certificate) {
    text += fmt::format("\nNo certificate was tried, because the run is not converged: {}.\n",
                        to_string(report.reason));
  }
  if (facts.certificate) text += fmt::format("\n{}\n", to_string(*facts.certificate));
  if (facts.of_better) text += fmt::format("The better one is the result. {}\n", to_string(*facts.of_better));
  if (facts.skipped_lines > 0)
    text += fmt::format("\n{} line{} of the file {} skipped.\n", facts.skipped_lines,
                        facts.skipped_lines == 1 ? "" : "s", facts.skipped_lines == 1 ? "was" : "were");
  text += fmt::format("\nThe optimized graph is {}.\n", escaped(where_written(arguments, facts)));
  print_summary(outputs_of(arguments), text);
}

void print_why_stopped(const Report& report, const RunFacts& facts, const OptimizeArguments& arguments) {
  if (report.converged()) return;
  const bool on_page = report.reason == Report::Reason::kCallback;
  if (on_page || report.reason == Report::Reason::kStopFlag) {
    print_message(fmt::format("{}: {} after {} iteration{}; the best estimate is {}",
                              input_name(arguments.input), on_page ? "stopped on the page" : "interrupted",
                              report.iterations, report.iterations == 1 ? "" : "s",
                              where_written(arguments, facts)));
  } else {
    print_message(fmt::format("{}: {}", input_name(arguments.input), report.message));
  }
}

}  // namespace boxplus::app
