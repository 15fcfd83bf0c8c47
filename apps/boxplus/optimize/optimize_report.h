// SPDX-License-Identifier: BSD-3-Clause
// What `boxplus optimize` says in the end.
#pragma once

#include <vector>

#include "boxplus/optimize/report.h"
#include "files/outputs.h"
#include "optimize/optimize_options.h"
#include "optimize/report_json.h"

namespace boxplus::app {

std::vector<Output> outputs_of(const OptimizeArguments& arguments);

/// The report for people, on stdout, or on stderr where stdout holds an output.
void print_report(const Report& report, const RunFacts& facts, const OptimizeArguments& arguments);

/// A message where the run did not converge.
void print_why_stopped(const Report& report, const OptimizeArguments& arguments);

}  // namespace boxplus::app
