// SPDX-License-Identifier: BSD-3-Clause
// Triangular solves with one right-hand side: bound by reading L, four columns at a time.
#pragma once

#include "kernels/simd_pack.h"

namespace boxplus::dense::BOXPLUS_ISA {

/// work[i] −= Σ_j column_j[i] y[j] for `Columns` columns.
template <int Columns>
void subtract_columns(const double* columns, int ld, const double* y, int count, double* __restrict work) {
  double factor[Columns];
  for (int j = 0; j < Columns; ++j) factor[j] = y[j];
  for (int i = 0; i < count; ++i) {
    double value = work[i];
    for (int j = 0; j < Columns; ++j) value -= columns[i + static_cast<long>(j) * ld] * factor[j];
    work[i] = value;
  }
}

/// y[j] −= column_j · work for `Columns` columns.
template <int Columns>
void subtract_dots(const double* columns, int ld, const double* work, int count, double* y) {
  Pack sums[Columns] = {};
  double tails[Columns] = {};
  int i = 0;
  for (; i + kLanes <= count; i += kLanes) {
    const Pack w = load(work + i);
#pragma GCC unroll 4
    for (int j = 0; j < Columns; ++j) {
      sums[j] += load(columns + i + static_cast<long>(j) * ld) * w;
    }
  }
  for (; i < count; ++i) {
    for (int j = 0; j < Columns; ++j) tails[j] += columns[i + static_cast<long>(j) * ld] * work[i];
  }
  for (int j = 0; j < Columns; ++j) y[j] -= sum(sums[j]) + tails[j];
}

template <int Columns>
void forward_columns(const double* diagonal, int ld, int below, double* y) {
  for (int j = 0; j < Columns; ++j) {
    for (int k = 0; k < j; ++k) y[j] -= diagonal[j + k * ld] * y[k];
    y[j] /= diagonal[j + j * ld];
  }
  subtract_columns<Columns>(diagonal + Columns, ld, y, below, y + Columns);
}

template <int Columns>
void backward_columns(const double* diagonal, int ld, int below, double* y) {
  subtract_dots<Columns>(diagonal + Columns, ld, y + Columns, below, y);
  for (int j = Columns - 1; j >= 0; --j) {
    for (int k = j + 1; k < Columns; ++k) y[j] -= diagonal[k + j * ld] * y[k];
    y[j] /= diagonal[j + j * ld];
  }
}

inline constexpr int kGroup = 4;

inline void solve_forward(const double* panel, int rows, int columns, int ld, double* work) {
  int j = 0;
  const auto diagonal = [&] { return panel + j + static_cast<long>(j) * ld; };
  for (; j + kGroup <= columns; j += kGroup)
    forward_columns<kGroup>(diagonal(), ld, rows - j - kGroup, work + j);
  if (columns - j == 3) return forward_columns<3>(diagonal(), ld, rows - j - 3, work + j);
  if (columns - j == 2) return forward_columns<2>(diagonal(), ld, rows - j - 2, work + j);
  if (columns - j == 1) return forward_columns<1>(diagonal(), ld, rows - j - 1, work + j);
}

inline void solve_backward(const double* panel, int rows, int columns, int ld, double* work) {
  int j = columns - columns % kGroup;
  const auto diagonal = [&] { return panel + j + static_cast<long>(j) * ld; };
  if (columns - j == 3) backward_columns<3>(diagonal(), ld, rows - j - 3, work + j);
  if (columns - j == 2) backward_columns<2>(diagonal(), ld, rows - j - 2, work + j);
  if (columns - j == 1) backward_columns<1>(diagonal(), ld, rows - j - 1, work + j);
  for (j -= kGroup; j >= 0; j -= kGroup)
    backward_columns<kGroup>(diagonal(), ld, rows - j - kGroup, work + j);
}

}  // namespace boxplus::dense::BOXPLUS_ISA
