// SPDX-License-Identifier: BSD-3-Clause
// Default widths of robust kernels.
#pragma once

#include <memory>
#include <string_view>

#include "boxplus/robust/robust_kernel.h"

namespace boxplus {

/// The quantile of the chi-squared distribution with `rows` degrees of freedom: a variable of this
/// distribution is below it with the given probability. The chi2 = eᵀΩe of an inlier with `rows` rows has
/// this distribution. Exact to 12 digits, for any number of rows. Throws InvalidArgument unless rows ≥ 1 and
/// 0 < probability ≤ 1 − 1e-9. O(√rows).
double chi2_quantile(int rows, double probability);

/// √chi2_quantile(rows, 0.95): 95 % of inliers have a whitened error √e² below it. It is 1.96 for one row,
/// 2.45 for two, 2.80 for three, 3.55 for six. A fixed width suits only one number of rows, because the error
/// of an inlier grows like √rows.
///
///     graph.set_kernel(edge, Cauchy(default_width(3)));
///
/// The widths of GemanMcClure and DCS are in units of e², so use chi2_quantile(3, 0.95) for these two
/// kernels.
double default_width(int rows);

/// make_robust_kernel() with the default width for errors of `rows` rows: default_width(rows), or its square
/// for the kernels whose width is in units of e². Throws InvalidArgument in the same cases as
/// make_robust_kernel(), and if rows < 1.
std::unique_ptr<RobustKernel> make_default_kernel(std::string_view name, int rows);

}  // namespace boxplus
