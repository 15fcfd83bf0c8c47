// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

namespace boxplus {

/// The instruction set that the dense kernels use: "baseline", "avx2", "avx512" or "neon" (64-bit ARM). It
/// is the best set that the processor can run, unless the environment variable BOXPLUS_ISA names another of
/// instruction_sets(). Other values of the variable have no effect.
std::string_view instruction_set();
/// The instruction sets that this processor can run, the best one last.
std::vector<std::string_view> instruction_sets();

}  // namespace boxplus
