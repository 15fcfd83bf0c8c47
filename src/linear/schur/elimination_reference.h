// SPDX-License-Identifier: BSD-3-Clause
// The kernels of an elimination for blocks of any size, written as plain loops.
#pragma once

#include "kernels/kernel_table.h"

namespace boxplus {

/// Kernels for blocks of any size. Each instruction set has faster kernels for common sizes.
extern const dense::EliminationKernels kEliminationReference;

}  // namespace boxplus
