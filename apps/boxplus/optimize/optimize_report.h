// SPDX-License-Identifier: BSD-3-Clause
// The final messages of `boxplus optimize`.
#pragma once

#include <string>
#include <vector>

#include "boxplus/optimize/report.h"
#include "files/outputs.h"
#include "optimize/optimize_options.h"
#include "optimize/report_json.h"

namespace boxplus::app {

/// Returns "Huber kernel of width 2 on 6 of 125 edges". `edges` is the number of all edges.
std::string kernel_text(const KernelFacts& kernel, std::size_t edges);

std::vector<Output> outputs_of(const OptimizeArguments& arguments);

/// Prints the report for the user to stdout, or to stderr if stdout is one of the outputs.
void print_report(const Report& report, const RunFacts& facts, const OptimizeArguments& arguments);

/// If the run did not converge, prints a message with the reason.
void print_why_stopped(const Report& report, const RunFacts& facts, const OptimizeArguments& arguments);

}  // namespace boxplus::app
