// SPDX-License-Identifier: BSD-3-Clause
// Steps of the commands that optimize a file.
#pragma once

#include <exception>
#include <string>

#include "boxplus/io/graph_file.h"
#include "boxplus/optimize/report.h"
#include "optimize/optimize_options.h"
#include "optimize/report_json.h"

namespace boxplus::app {

int exit_code(Report::Status status);

/// Throws if an option is given that has no meaning, because another option has not the value that it needs.
void require_needed_values(const CLI::App& command);

void require_edges(const GraphFile& file, const std::string& path);

/// Writes the result. If its format cannot hold the new estimates, writes JSON beside it, so that no result
/// is lost, unless the user wants to know by the exit code: then returns the error.
std::exception_ptr save_result(const OptimizeArguments& arguments, const GraphFile& file, RunFacts& facts);

}  // namespace boxplus::app
