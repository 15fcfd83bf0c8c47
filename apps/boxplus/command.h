// SPDX-License-Identifier: BSD-3-Clause
// The common parts of the sub-commands of `boxplus`. Results go to stdout, messages to stderr.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace boxplus::app {

/// The exit codes, as documented in --help.
enum ExitCode : int { kSuccess = 0, kNotConverged = 1, kBadInput = 2, kNumericalFailure = 3 };

/// The work of a sub-command, run after the command line is read; returns the exit code.
using Action = std::function<int()>;

/// Each function adds its sub-command, which sets `action` if the user chooses it.
void add_optimize(CLI::App& app, Action& action);
void add_info(CLI::App& app, Action& action);
void add_convert(CLI::App& app, Action& action);
void add_simulate(CLI::App& app, Action& action);
void add_plot(CLI::App& app, Action& action);
void add_compare(CLI::App& app, Action& action);
void add_completion(CLI::App& app, Action& action);
void add_help(CLI::App& app, Action& action);  ///< must be called last, because it lists the others

}  // namespace boxplus::app
