// SPDX-License-Identifier: BSD-3-Clause
// Robust kernels as they are named on the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace boxplus::app {

/// Accepts what make_robust_kernel() knows, "Barron:1.5" too, in any case of letters, and spells it out.
CLI::Validator kernel_name();

/// "DCS and GemanMcClure": the kernels whose width is in units of e².
std::string kernels_with_squared_width();

}  // namespace boxplus::app
