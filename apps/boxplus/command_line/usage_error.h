// SPDX-License-Identifier: BSD-3-Clause
// Replaces the error messages of CLI11 about the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace boxplus::app {

/// Returns a message that says why `app` could not parse its arguments, and how to get help.
std::string usage_message(const CLI::App& app, const CLI::ParseError& error);

}  // namespace boxplus::app
