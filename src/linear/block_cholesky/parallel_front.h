// SPDX-License-Identifier: BSD-3-Clause
// The dense work of one large front on several threads. The results have the same bits as on one thread.
// Scalar is double or float.
#pragma once

#include "boxplus/base/stop_token.h"
#include "kernels/kernel_table.h"

namespace boxplus {

inline constexpr int kPanelStopped = -1;

/// Does the same as dense::factor_panel(), but with several threads. Returns kPanelStopped if the stop token
/// was raised.
template <class Scalar>
int factor_panel_with(int threads, const StopToken& stop, Scalar* panel, int rows, int columns, int ld,
                      const Scalar* minimum_pivot);

/// Does the same as dense::set_to_minus_square() for all columns, but with several threads. Returns false if
/// the stop token was raised.
template <class Scalar>
bool set_to_minus_square_with(int threads, const StopToken& stop, Scalar* c, int ldc, const Scalar* a,
                              int lda, int size, int k);

/// Does an extend-add. Divides its columns among the threads.
template <class Scalar>
void extend_add_with(int threads, const dense::ExtendAdd<Scalar>& task);

}  // namespace boxplus
