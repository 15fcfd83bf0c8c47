// SPDX-License-Identifier: BSD-3-Clause
// Executes commands of the protocol (protocol.h) from standard input.
#pragma once

#include <functional>
#include <string_view>

#include "boxplus/graph/graph.h"

namespace boxplus::app {

struct CommandCalls {
  std::function<void()> solve;                   ///< for each SOLVE_STATE
  std::function<void(std::string_view)> answer;  ///< writes an answer
  std::function<void()> idle = [] {};            ///< about ten times per second while nothing arrives
};

/// Executes the commands of standard input as they arrive, until it ends or Interrupt is raised. Throws
/// InputError for the first command that is wrong, and FileError if standard input cannot be read.
void serve_commands(Graph& graph, const CommandCalls& calls);

}  // namespace boxplus::app
