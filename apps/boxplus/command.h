// SPDX-License-Identifier: BSD-3-Clause
// The parts that all sub-commands of `boxplus` share. Results go to stdout, and messages go to stderr.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace boxplus::app {

/// The exit codes, as documented in --help.
enum ExitCode : int { kSuccess = 0, kNotConverged = 1, kBadInput = 2, kNumericalFailure = 3 };

/// Does the work of a sub-command and returns the exit code. main() calls it after it has parsed the command
/// line.
using Action = std::function<int()>;

/// Each of these functions adds one sub-command to `app`. If the user chooses this sub-command, it sets
/// `action`.
void add_optimize(CLI::App& app, Action& action);
void add_info(CLI::App& app, Action& action);
void add_convert(CLI::App& app, Action& action);
void add_simulate(CLI::App& app, Action& action);
void add_plot(CLI::App& app, Action& action);
void add_view(CLI::App& app, Action& action);
void add_compare(CLI::App& app, Action& action);
void add_replay(CLI::App& app, Action& action);
void add_completion(CLI::App& app, Action& action);
/// Must be called last, because `help` lists the other sub-commands.
void add_help(CLI::App& app, Action& action);

}  // namespace boxplus::app
