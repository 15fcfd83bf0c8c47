// SPDX-License-Identifier: BSD-3-Clause
// JᵀΩJ and JᵀΩe of one small edge.
#pragma once

#include "kernels/kernel_table.h"
#include "kernels/simd_pack.h"

namespace boxplus::dense::BOXPLUS_ISA {

/// Ω times the weight, all of it, row by row.
inline void expand(const EdgeNumbers& edge, double* omega) {
  const double* value = edge.omega;
  for (int r = 0; r < edge.rows; ++r) {
    for (int s = r; s < edge.rows; ++s) {
      const double entry = edge.weight * *value++;
      omega[r * kMostEdgeRows + s] = entry;
      omega[s * kMostEdgeRows + r] = entry;
    }
  }
}

/// Columns [b, b + Columns) of products = Jᵀ (ΩJ), both factors row by row.
template <int Packs, int Columns>
inline void product_columns(const double* rows_of_j, const double* rows_of_wj, int rows, int b,
                            double* products) {
  constexpr int kStride = Packs * kLanes;
  Pack tile[Columns][Packs] = {};
  for (int r = 0; r < rows; ++r) {
    Pack row[Packs];
#pragma GCC unroll 8
    for (int p = 0; p < Packs; ++p) row[p] = load(rows_of_j + r * kStride + p * kLanes);
#pragma GCC unroll 4
    for (int j = 0; j < Columns; ++j) {
      const double factor = rows_of_wj[r * kStride + b + j];
#pragma GCC unroll 8
      for (int p = 0; p < Packs; ++p) tile[j][p] += row[p] * factor;
    }
  }
#pragma GCC unroll 4
  for (int j = 0; j < Columns; ++j) {
#pragma GCC unroll 8
    for (int p = 0; p < Packs; ++p) store(products + (b + j) * kStride + p * kLanes, tile[j][p]);
  }
}

template <int Packs>
inline void normal_products_of(const EdgeNumbers& edge, double* products, double* gradient) {
  constexpr int kStride = Packs * kLanes;
  const int rows = edge.rows, cols = edge.cols;
  double j[kMostEdgeRows * kStride], wj[kMostEdgeRows * kStride];
  double omega[kMostEdgeRows * kMostEdgeRows], weighted_error[kMostEdgeRows];
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) j[r * kStride + c] = edge.jacobian[c * rows + r];
    for (int c = cols; c < kStride; ++c) j[r * kStride + c] = 0;
  }
  if (edge.kind == EdgeNumbers::kFull) expand(edge, omega);
  for (int r = 0; r < rows; ++r) {
    Pack row[Packs] = {};
    double error = 0;
    const auto add = [&](int s, double factor) {
#pragma GCC unroll 8
      for (int p = 0; p < Packs; ++p) row[p] += load(j + s * kStride + p * kLanes) * factor;
      error += factor * edge.error[s];
    };
    if (edge.kind == EdgeNumbers::kFull) {
      for (int s = 0; s < rows; ++s) add(s, omega[r * kMostEdgeRows + s]);
    } else {
      add(r, edge.weight * edge.omega[edge.kind == EdgeNumbers::kScalar ? 0 : r]);
    }
#pragma GCC unroll 8
    for (int p = 0; p < Packs; ++p) store(wj + r * kStride + p * kLanes, row[p]);
    weighted_error[r] = error;
  }
  Pack sums[Packs] = {};
  for (int r = 0; r < rows; ++r) {
#pragma GCC unroll 8
    for (int p = 0; p < Packs; ++p) sums[p] += load(j + r * kStride + p * kLanes) * weighted_error[r];
  }
#pragma GCC unroll 8
  for (int p = 0; p < Packs; ++p) store(gradient + p * kLanes, sums[p]);
  int b = 0;
  if constexpr (Packs <= 4) {
    for (; b + 4 <= cols; b += 4) product_columns<Packs, 4>(j, wj, rows, b, products);
  }
  for (; b + 2 <= cols; b += 2) product_columns<Packs, 2>(j, wj, rows, b, products);
  if (b < cols) product_columns<Packs, 1>(j, wj, rows, b, products);
}

/// normal_products_of for the fewest packs that hold `columns`.
template <int Packs = 1>
inline int normal_products(const EdgeNumbers& edge, double* products, double* gradient) {
  if constexpr (Packs * kLanes < kMostEdgeColumns) {
    if (edge.cols > Packs * kLanes) return normal_products<Packs + 1>(edge, products, gradient);
  }
  normal_products_of<Packs>(edge, products, gradient);
  return Packs * kLanes;
}

/// to[0 … N) += from[0 … N), no byte beyond: a wider access would wait for the store of the column before.
template <int N>
inline void add_column(double* to, const double* from) {
#if defined(__GNUC__)
  constexpr int kWidth = N >= 4 ? 4 : N >= 2 ? 2 : 1;
  typedef double Part __attribute__((vector_size(kWidth * sizeof(double))));
  Part sum, term;
  __builtin_memcpy(&sum, to, sizeof(Part));
  __builtin_memcpy(&term, from, sizeof(Part));
  sum += term;
  __builtin_memcpy(to, &sum, sizeof(Part));
#else
  constexpr int kWidth = 1;
  *to += *from;
#endif
  if constexpr (N > kWidth) add_column<N - kWidth>(to + kWidth, from + kWidth);
}

template <int Rows>
inline void add_columns(double* block, int cols, const double* source, int stride) {
  for (int c = 0; c < cols; ++c) add_column<Rows>(block + c * Rows, source + c * stride);
}

inline void add_block(double* block, int rows, int cols, const double* source, int stride) {
  switch (rows) {
    case 2:
      return add_columns<2>(block, cols, source, stride);
    case 3:
      return add_columns<3>(block, cols, source, stride);
    case 6:
      return add_columns<6>(block, cols, source, stride);
    default:
      for (int c = 0; c < cols; ++c) {
        for (int r = 0; r < rows; ++r) block[c * rows + r] += source[c * stride + r];
      }
  }
}

}  // namespace boxplus::dense::BOXPLUS_ISA
