// SPDX-License-Identifier: BSD-3-Clause
// Checks names of robust kernels on the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace boxplus::app {

/// Accepts the names that make_robust_kernel() knows, including names with a shape such as "Barron:1.5", in
/// upper or lower case. Replaces each name by its usual spelling.
CLI::Validator kernel_name();

/// Returns the names of the kernels whose width is in units of e²: "DCS and GemanMcClure".
std::string kernels_with_squared_width();

}  // namespace boxplus::app
