// SPDX-License-Identifier: BSD-3-Clause
// JᵀΩJ and JᵀΩe of one small edge.
#pragma once

#include "kernels/kernel_table.h"
#include "kernels/simd_pack.h"
#include "kernels/transpose.h"

namespace boxplus::dense::BOXPLUS_ISA {

/// Computes and stores ΩJ row by row. The lanes of a pack are consecutive columns. Rows is the number of
/// rows, or 0 if it is known only at run time.
template <int Rows, int Packs>
class NormalProducts {
 public:
  explicit NormalProducts(const EdgeNumbers& edge) : edge_(edge) { weigh(); }

  /// products = (ΩJ)ᵀJ, column by column, and gradient = (ΩJ)ᵀe. These products equal JᵀΩJ and JᵀΩe, because
  /// Ω is symmetric.
  void multiply(double* products, double* gradient) const {
    int b = 0;
    if constexpr (Packs <= 3) {
      for (; b + 4 <= edge_.cols; b += 4) columns<4>(edge_.jacobian + b, products + b * kStride);
    }
    for (; b + 2 <= edge_.cols; b += 2) columns<2>(edge_.jacobian + b, products + b * kStride);
    if (b < edge_.cols) columns<1>(edge_.jacobian + b, products + b * kStride);
    columns<1>(&edge_.error, gradient);
  }

 private:
  static constexpr int kStride = Packs * kLanes, kRoom = Rows > 0 ? Rows : kMostEdgeRows;

  static constexpr int rows_of(const EdgeNumbers& edge) { return Rows > 0 ? Rows : edge.rows; }

  /// Computes weighted_ = ΩJ.
  void weigh() {
    const int rows = rows_of(edge_);
    Pack jacobian[Packs][kRoom];
    for (int p = 0; p < Packs; ++p) {
      const double* columns[kLanes];
      for (int l = 0; l < kLanes; ++l) {
        const int column = p * kLanes + l;
        columns[l] = edge_.jacobian[column < edge_.cols ? column : 0];
      }
      load_lanes(columns, jacobian[p], rows);
    }
    const auto add = [&](int r, int s, double factor) {
#pragma GCC unroll 8
      for (int p = 0; p < Packs; ++p) weighted_[r][p] += jacobian[p][s] * factor;
    };
    for (int r = 0; r < rows; ++r) {
      for (int p = 0; p < Packs; ++p) weighted_[r][p] = Pack{};
    }
    const double* omega = edge_.omega;
    if (edge_.kind == EdgeNumbers::kFull) {
#pragma GCC unroll 6
      for (int r = 0; r < rows; ++r) {
        add(r, r, edge_.weight * *omega++);
#pragma GCC unroll 6
        for (int s = r + 1; s < rows; ++s) {
          const double factor = edge_.weight * *omega++;
          add(r, s, factor);
          add(s, r, factor);
        }
      }
    } else {
      for (int r = 0; r < rows; ++r)
        add(r, r, edge_.weight * omega[edge_.kind == EdgeNumbers::kScalar ? 0 : r]);
    }
  }

  /// to = (ΩJ)ᵀ from, column by column.
  template <int Columns>
  void columns(const double* const* from, double* to) const {
    const int rows = rows_of(edge_);
    Pack tile[Columns][Packs] = {};
#pragma GCC unroll 6
    for (int r = 0; r < rows; ++r) {
#pragma GCC unroll 4
      for (int j = 0; j < Columns; ++j) {
        const double factor = from[j][r];
#pragma GCC unroll 8
        for (int p = 0; p < Packs; ++p) tile[j][p] += weighted_[r][p] * factor;
      }
    }
#pragma GCC unroll 4
    for (int j = 0; j < Columns; ++j) {
#pragma GCC unroll 8
      for (int p = 0; p < Packs; ++p) store(to + j * kStride + p * kLanes, tile[j][p]);
    }
  }

  const EdgeNumbers& edge_;
  Pack weighted_[kRoom][Packs];
};

/// Uses the smallest number of packs that can hold the columns.
template <int Rows, int Packs = 1>
inline int normal_products_of(const EdgeNumbers& edge, double* products, double* gradient) {
  if constexpr (Packs * kLanes < kMostEdgeColumns) {
    if (edge.cols > Packs * kLanes) return normal_products_of<Rows, Packs + 1>(edge, products, gradient);
  }
  NormalProducts<Rows, Packs>(edge).multiply(products, gradient);
  return Packs * kLanes;
}

inline int normal_products(const EdgeNumbers& edge, double* products, double* gradient) {
  switch (edge.rows) {
    case 2:
      return normal_products_of<2>(edge, products, gradient);
    case 3:
      return normal_products_of<3>(edge, products, gradient);
    case 6:
      return normal_products_of<6>(edge, products, gradient);
    default:
      return normal_products_of<0>(edge, products, gradient);
  }
}

/// to[i] += from[i] for 0 ≤ i < N. Accesses no other values, because a load that includes the previous column
/// would have to wait until that column has been stored.
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
