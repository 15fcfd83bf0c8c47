// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/run_steps.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "boxplus/base/error.h"
#include "command.h"
#include "command_line/message.h"
#include "files/graph_input.h"
#include "files/outputs.h"
#include "settings/setting_table.h"

namespace boxplus::app {

int exit_code(Report::Status status) {
  switch (status) {
    case Report::Status::kConverged:
      return kSuccess;
    case Report::Status::kNotConverged:
      return kNotConverged;
    default:
      return kNumericalFailure;
  }
}

void require_needed_values(const CLI::App& command) {
  for (const Setting& setting : setting_table()) {
    if (setting.needed_value.empty() || command.count("--" + setting.name) == 0) continue;
    const std::string needed = "--" + setting.needed_setting;
    if (command.count(needed) == 0 || command.get_option(needed)->as<std::string>() != setting.needed_value)
      throw CLI::RequiresError("--" + setting.name, needed + " " + setting.needed_value);
  }
}

void require_edges(const GraphFile& file, const std::string& path) {
  if (file.graph.edge_count() == 0)
    throw InputError(input_name(path), file.lines + 1, 1, "expected an edge, got the end of the file");
}

std::exception_ptr save_result(const OptimizeArguments& arguments, const GraphFile& file, RunFacts& facts) {
  try {
    save_graph(arguments.output, file, {}, arguments.quiet);
    facts.output = arguments.output;
    return nullptr;
  } catch (const InvalidArgument& error) {
    std::exception_ptr refusal = std::current_exception();
    if (arguments.strict_output || arguments.output == kStandardStream) return refusal;
    std::string name = arguments.output;
    while (name.ends_with('/')) name.pop_back();
    name += ".json";
    try {
      save_graph(name, file, {}, arguments.quiet);
    } catch (const InvalidArgument&) {
      return refusal;
    }
    print_message(fmt::format("{}: {}; wrote {} instead", arguments.output, error.what(), name));
    facts.output = name;
    return nullptr;
  }
}

}  // namespace boxplus::app
