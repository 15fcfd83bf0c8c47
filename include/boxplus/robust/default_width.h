// SPDX-License-Identifier: BSD-3-Clause
// How wide a robust kernel should be when nothing better is known.
#pragma once

namespace boxplus {

/// The value that a chi2-distributed variable of `rows` degrees of freedom stays below with this probability.
/// chi2 = eᵀΩe of a good measurement with `rows` rows is such a variable. Exact to
/// 12 digits, for any number of rows. Throws InvalidArgument unless rows ≥ 1 and
/// 0 < probability ≤ 1 − 1e-9. O(√rows).
double chi2_quantile(int rows, double probability);

/// √chi2_quantile(rows, 0.95): 95 % of good measurements have a whitened error √e² below it. 1.96 for one
/// row, 2.45 for two, 2.80 for three, 3.55 for six. A fixed width suits one number of rows only: the error of
/// a good measurement grows like √rows.
///
///     graph.set_kernel(edge, Cauchy(default_width(3)));
///
/// GemanMcClure and DCS, whose widths are in units of e², take chi2_quantile(3, 0.95).
double default_width(int rows);

}  // namespace boxplus
