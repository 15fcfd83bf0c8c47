// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

namespace boxplus {

/// Which instructions the dense kernels are made for: "baseline", "avx2" or "avx512". The best that the
/// processor can run, or what the environment variable BOXPLUS_ISA names; where it names none of
/// instruction_sets(), it has no effect.
std::string_view instruction_set();
/// Those that this processor can run, the best one last.
std::vector<std::string_view> instruction_sets();

}  // namespace boxplus
