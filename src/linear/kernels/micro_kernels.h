// SPDX-License-Identifier: BSD-3-Clause
// Register tiles: a strip of rows (some packs) times up to four columns, accumulated over k.
#pragma once

#include "linear/kernels/simd_pack.h"

namespace boxplus::dense {

/// B of the product A B or A Bᵀ: entry (k, column) is at data[k * step_k + column * step_column].
struct Operand {
  const double* data;
  int step_k, step_column;
};

/// What becomes of the tile: C −= A·B, C = −A·B, or C = (C − A·B) T⁻ᵀ with a lower triangle T (inverse
/// diagonal given).
enum class TileUse { kSubtract, kSet, kDivide };

struct Triangle {
  const double* data;
  int ld;
  const double* inverse_diagonal;
};

/// One tile of Packs·lanes rows and Columns columns.
template <TileUse Use, class Pack, int Packs, int Columns>
inline void run_tile(double* __restrict c, int ldc, const double* a, int lda, Operand b, int k, Triangle t) {
  Pack tile[Columns][Packs];
#pragma GCC unroll 8
  for (int j = 0; j < Columns; ++j) {
#pragma GCC unroll 8
    for (int p = 0; p < Packs; ++p) {
      tile[j][p] = Use == TileUse::kSet ? Pack{} : load<Pack>(c + j * ldc + p * kLanes<Pack>);
    }
  }
  for (int i = 0; i < k; ++i) {
    Pack column[Packs];
#pragma GCC unroll 8
    for (int p = 0; p < Packs; ++p) column[p] = load<Pack>(a + p * kLanes<Pack>);
#pragma GCC unroll 8
    for (int j = 0; j < Columns; ++j) {
      const double factor = b.data[j * b.step_column];
#pragma GCC unroll 8
      for (int p = 0; p < Packs; ++p) tile[j][p] -= column[p] * factor;
    }
    a += lda;
    b.data += b.step_k;
  }
  if constexpr (Use == TileUse::kDivide) {
#pragma GCC unroll 8
    for (int j = 0; j < Columns; ++j) {
#pragma GCC unroll 8
      for (int p = 0; p < Packs; ++p) {
#pragma GCC unroll 8
        for (int i = 0; i < j; ++i) tile[j][p] -= tile[i][p] * t.data[j + i * t.ld];
        tile[j][p] *= t.inverse_diagonal[j];
      }
    }
  }
#pragma GCC unroll 8
  for (int j = 0; j < Columns; ++j) {
#pragma GCC unroll 8
    for (int p = 0; p < Packs; ++p) store(c + j * ldc + p * kLanes<Pack>, tile[j][p]);
  }
}

/// A column of tiles: all `rows` of C, `Columns` columns.
template <TileUse Use, int Columns>
void run_strip(double* c, int ldc, const double* a, int lda, Operand b, int rows, int k, Triangle t) {
  int i = 0;
  constexpr int kWide = kLanes<Wide>, kPair = kLanes<Pair>;
  for (; i + 2 * kWide <= rows; i += 2 * kWide) {
    run_tile<Use, Wide, 2, Columns>(c + i, ldc, a + i, lda, b, k, t);
  }
  if constexpr (kWide > kPair) {
    for (; i + kWide <= rows; i += kWide) run_tile<Use, Wide, 1, Columns>(c + i, ldc, a + i, lda, b, k, t);
  }
  for (; i + kPair <= rows; i += kPair) run_tile<Use, Pair, 1, Columns>(c + i, ldc, a + i, lda, b, k, t);
  if constexpr (kPair > 1) {
    for (; i < rows; ++i) run_tile<Use, double, 1, Columns>(c + i, ldc, a + i, lda, b, k, t);
  }
}

/// The widest strip that the kernels have.
inline constexpr int kStrip = 4;

/// run_strip for 1 … kStrip columns.
template <TileUse Use>
inline void run_strip(int columns, double* c, int ldc, const double* a, int lda, Operand b, int rows, int k,
                      Triangle t = {}) {
  switch (columns) {
    case 1:
      return run_strip<Use, 1>(c, ldc, a, lda, b, rows, k, t);
    case 2:
      return run_strip<Use, 2>(c, ldc, a, lda, b, rows, k, t);
    case 3:
      return run_strip<Use, 3>(c, ldc, a, lda, b, rows, k, t);
    default:
      return run_strip<Use, 4>(c, ldc, a, lda, b, rows, k, t);
  }
}

/// Width of the next strip of `left` columns: no lone last column where that can be avoided (5 = 3 + 2, 6 = 3
/// + 3).
inline int strip_width(int left) {
  return left == 5 || left == 6 ? 3 : left < kStrip ? left : kStrip;
}

}  // namespace boxplus::dense
