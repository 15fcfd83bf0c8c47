// SPDX-License-Identifier: BSD-3-Clause
// The dense work of one large front on several threads. The same bits as with one.
#pragma once

namespace boxplus {

/// dense::factor_panel.
int factor_panel_with(int threads, double* panel, int rows, int columns, int ld, const double* minimum_pivot);

/// dense::set_to_minus_square.
void set_to_minus_square_with(int threads, double* c, int ldc, const double* a, int lda, int size, int k);

}  // namespace boxplus
