// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/between.h"

#include "kernels/kernel_table.h"

namespace boxplus::detail {

void linearize_between(std::type_identity<SE2>, int count, const double* const* measurement,
                       const double* const* from, const double* const* to, double* error, double* jacobian) {
  dense::kernels().between_se2({count, measurement, from, to}, error, jacobian);
}

void linearize_between(std::type_identity<SE3>, int count, const double* const* measurement,
                       const double* const* from, const double* const* to, double* error, double* jacobian) {
  dense::kernels().between_se3({count, measurement, from, to}, error, jacobian);
}

}  // namespace boxplus::detail
