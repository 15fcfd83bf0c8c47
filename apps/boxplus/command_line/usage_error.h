// SPDX-License-Identifier: BSD-3-Clause
// Complaints about the command line, in our words.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace boxplus::app {

/// One sentence on why `app` could not read its arguments, and where to look.
std::string usage_message(const CLI::App& app, const CLI::ParseError& error);

}  // namespace boxplus::app
