// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "boxplus/robust/robust_kernel.h"

namespace boxplus {

/// Whether the influence of an edge, ρ′(e²)·|e|, falls to zero for large errors |e|, as for the kernels of
/// redescending.h. The influence of Huber and similar kernels does not fall. Evaluates the kernel once, at an
/// error of 10,000 widths.
bool is_redescending(const RobustKernel& kernel);

}  // namespace boxplus
