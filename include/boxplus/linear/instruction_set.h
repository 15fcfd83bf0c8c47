// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

namespace boxplus {

/// The instruction set of the dense kernels in use: "baseline", "avx2" or "avx512". It is the best that the
/// processor can run, or the one that the environment variable BOXPLUS_ISA names. The variable has no effect
/// if its value is not one of instruction_sets().
std::string_view instruction_set();
/// The instruction sets that this processor can run, the best one last.
std::vector<std::string_view> instruction_sets();

}  // namespace boxplus
