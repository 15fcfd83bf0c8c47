// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/base_edge.h"
#include "kernels/kernel_table.h"

namespace g2o {
namespace internal {

namespace dense = boxplus::dense;

static_assert(kMostProductColumns == dense::kMostEdgeColumns);

int normalProducts(int rows, int cols, const double* const* jacobian, const double* omega,
                   const double* error, double* products, double* gradient) {
  return dense::kernels().normal_products({rows, cols, jacobian, error, dense::EdgeNumbers::kFull, omega, 1},
                                          products, gradient);
}

}  // namespace internal
}  // namespace g2o
