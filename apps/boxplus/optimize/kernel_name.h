// SPDX-License-Identifier: BSD-3-Clause
// Robust kernels as they are named on the command line.
#pragma once

#include <CLI/CLI.hpp>

namespace boxplus::app {

/// Accepts what make_robust_kernel() knows, "Barron:1.5" too, in any case of letters, and spells it out.
CLI::Validator kernel_name();

}  // namespace boxplus::app
