// SPDX-License-Identifier: BSD-3-Clause
// The kernels of an elimination for blocks of any size, in plain loops.
#pragma once

#include "kernels/kernel_table.h"

namespace boxplus {

/// Work on blocks of every size; the kernels of each instruction set compute the same for common sizes.
extern const dense::EliminationKernels kEliminationReference;

/// The fastest kernels for blocks W of rows × dim.
inline const dense::EliminationKernels& elimination_kernels(int rows, int dim) {
  const dense::EliminationKernels* kernels = dense::kernels().elimination_kernels_for(rows, dim);
  return kernels != nullptr ? *kernels : kEliminationReference;
}

}  // namespace boxplus
