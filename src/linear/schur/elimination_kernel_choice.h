// SPDX-License-Identifier: BSD-3-Clause
// The choice of the kernels of an elimination.
#pragma once

#include <array>
#include <cstddef>

#include "kernels/kernel_table.h"
#include "linear/schur/elimination_reference.h"

namespace boxplus {

/// The fastest kernels for blocks W of rows × dim values, looked up once for all small sizes.
class EliminationKernelChoice {
 public:
  EliminationKernelChoice() {
    for (int rows = 0; rows <= kMostRows; ++rows) {
      for (int dim = 0; dim <= kMostDim; ++dim) {
        const dense::EliminationKernels* kernels = dense::kernels().elimination_kernels_for(rows, dim);
        choice_[rows][dim] = kernels != nullptr ? kernels : &kEliminationReference;
      }
    }
  }

  const dense::EliminationKernels& operator()(int rows, int dim) const {
    return rows <= kMostRows && dim <= kMostDim ? *choice_[rows][dim] : kEliminationReference;
  }

 private:
  /// There are no kernels for larger blocks.
  static constexpr int kMostRows = 22, kMostDim = 6;
  std::array<std::array<const dense::EliminationKernels*, kMostDim + 1>, kMostRows + 1> choice_;
};

}  // namespace boxplus
