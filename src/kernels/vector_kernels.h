// SPDX-License-Identifier: BSD-3-Clause
// Triangular solves with one right-hand side. Reading L takes most of the time, so the kernels process four
// columns of L at a time.
#pragma once

#include "kernels/simd_pack.h"

namespace boxplus::dense::BOXPLUS_ISA {

/// work[i] −= Σ_j column_j[i] y[j] for `Columns` columns.
template <int Columns, class Scalar>
void subtract_columns(const Scalar* columns, int ld, const Scalar* y, int count, Scalar* __restrict work) {
  Scalar factor[Columns];
  for (int j = 0; j < Columns; ++j) factor[j] = y[j];
  for (int i = 0; i < count; ++i) {
    Scalar value = work[i];
    for (int j = 0; j < Columns; ++j) value -= columns[i + static_cast<long>(j) * ld] * factor[j];
    work[i] = value;
  }
}

/// y[j] −= column_j · work for `Columns` columns.
template <int Columns, class Scalar>
void subtract_dots(const Scalar* columns, int ld, const Scalar* work, int count, Scalar* y) {
  constexpr int kWidth = kLanesOf<Scalar>;
  PackOf<Scalar> sums[Columns] = {};
  Scalar tails[Columns] = {};
  int i = 0;
  for (; i + kWidth <= count; i += kWidth) {
    const PackOf<Scalar> w = load(work + i);
#pragma GCC unroll 4
    for (int j = 0; j < Columns; ++j) {
      sums[j] += load(columns + i + static_cast<long>(j) * ld) * w;
    }
  }
  for (; i < count; ++i) {
    for (int j = 0; j < Columns; ++j) tails[j] += columns[i + static_cast<long>(j) * ld] * work[i];
  }
  for (int j = 0; j < Columns; ++j) y[j] -= sum_of<Scalar>(sums[j]) + tails[j];
}

template <int Columns, class Scalar>
void forward_columns(const Scalar* diagonal, int ld, int below, Scalar* y) {
  for (int j = 0; j < Columns; ++j) {
    for (int k = 0; k < j; ++k) y[j] -= diagonal[j + k * ld] * y[k];
    y[j] /= diagonal[j + j * ld];
  }
  subtract_columns<Columns>(diagonal + Columns, ld, y, below, y + Columns);
}

template <int Columns, class Scalar>
void backward_columns(const Scalar* diagonal, int ld, int below, Scalar* y) {
  subtract_dots<Columns>(diagonal + Columns, ld, y + Columns, below, y);
  for (int j = Columns - 1; j >= 0; --j) {
    for (int k = j + 1; k < Columns; ++k) y[j] -= diagonal[k + j * ld] * y[k];
    y[j] /= diagonal[j + j * ld];
  }
}

inline constexpr int kGroup = 4;

template <class Scalar>
void solve_forward(const Scalar* panel, int rows, int columns, int ld, Scalar* work) {
  int j = 0;
  const auto diagonal = [&] { return panel + j + static_cast<long>(j) * ld; };
  for (; j + kGroup <= columns; j += kGroup)
    forward_columns<kGroup>(diagonal(), ld, rows - j - kGroup, work + j);
  if (columns - j == 3) return forward_columns<3>(diagonal(), ld, rows - j - 3, work + j);
  if (columns - j == 2) return forward_columns<2>(diagonal(), ld, rows - j - 2, work + j);
  if (columns - j == 1) return forward_columns<1>(diagonal(), ld, rows - j - 1, work + j);
}

template <class Scalar>
void solve_backward(const Scalar* panel, int rows, int columns, int ld, Scalar* work) {
  int j = columns - columns % kGroup;
  const auto diagonal = [&] { return panel + j + static_cast<long>(j) * ld; };
  if (columns - j == 3) backward_columns<3>(diagonal(), ld, rows - j - 3, work + j);
  if (columns - j == 2) backward_columns<2>(diagonal(), ld, rows - j - 2, work + j);
  if (columns - j == 1) backward_columns<1>(diagonal(), ld, rows - j - 1, work + j);
  for (j -= kGroup; j >= 0; j -= kGroup)
    backward_columns<kGroup>(diagonal(), ld, rows - j - kGroup, work + j);
}

}  // namespace boxplus::dense::BOXPLUS_ISA
