// SPDX-License-Identifier: BSD-3-Clause
// The final messages of `boxplus optimize`.
#pragma once

#include <vector>

#include "boxplus/optimize/report.h"
#include "files/outputs.h"
#include "optimize/optimize_options.h"
#include "optimize/report_json.h"

namespace boxplus::app {

std::vector<Output> outputs_of(const OptimizeArguments& arguments);

/// Prints the report for the user on stdout, or on stderr if stdout holds an output.
void print_report(const Report& report, const RunFacts& facts, const OptimizeArguments& arguments);

/// Prints a message if the run did not converge.
void print_why_stopped(const Report& report, const OptimizeArguments& arguments);

}  // namespace boxplus::app
