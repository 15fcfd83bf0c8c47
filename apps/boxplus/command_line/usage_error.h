// SPDX-License-Identifier: BSD-3-Clause
// Error messages about the command line, in boxplus' own words.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace boxplus::app {

/// One sentence that says why `app` could not read its arguments, and where to find help.
std::string usage_message(const CLI::App& app, const CLI::ParseError& error);

}  // namespace boxplus::app
