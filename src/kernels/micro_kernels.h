// SPDX-License-Identifier: BSD-3-Clause
// Register tiles: a few packs of rows times a strip of columns, accumulated over k.
#pragma once

#include "kernels/simd_pack.h"

namespace boxplus::dense::BOXPLUS_ISA {

/// B of the product A B or A Bᵀ: entry (k, column) is at data[k * step_k + column * step_column].
struct Operand {
  const double* data;
  int step_k, step_column;
};

/// What becomes of the tile: C −= A·B, C = −A·B, or C = (C − A·B) T⁻ᵀ with a lower triangle T (inverse
/// diagonal given).
enum class TileUse { kSubtract, kSet, kDivide };

struct Triangle {
  const double* data = nullptr;
  int ld = 0;
  const double* inverse_diagonal = nullptr;
};

/// One tile of Packs packs of rows and Columns columns. Of the last pack only `lanes` count where IsTail.
template <TileUse Use, int Packs, int Columns, bool IsTail>
inline void run_tile(double* __restrict c, int ldc, const double* a, int lda, Operand b, int k, Triangle t,
                     Lanes lanes) {
  const auto load_pack = [&](const double* from, int p) {
    return IsTail && p == Packs - 1 ? lanes.load(from + p * kLanes) : load(from + p * kLanes);
  };
  Pack tile[Columns][Packs];
#pragma GCC unroll 8
  for (int j = 0; j < Columns; ++j) {
#pragma GCC unroll 8
    for (int p = 0; p < Packs; ++p) {
      tile[j][p] = Use == TileUse::kSet ? Pack{} : load_pack(c + static_cast<long>(j) * ldc, p);
    }
  }
  for (int i = 0; i < k; ++i) {
    Pack column[Packs];
#pragma GCC unroll 8
    for (int p = 0; p < Packs; ++p) column[p] = load_pack(a, p);
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
    double* to = c + static_cast<long>(j) * ldc;
#pragma GCC unroll 8
    for (int p = 0; p < Packs; ++p) {
      if (IsTail && p == Packs - 1) {
        lanes.store(to + p * kLanes, tile[j][p]);
      } else {
        store(to + p * kLanes, tile[j][p]);
      }
    }
  }
}

/// A column of tiles: all `rows` of C, `Columns` columns.
template <TileUse Use, int Columns>
void run_strip(double* c, int ldc, const double* a, int lda, Operand b, int rows, int k, Triangle t) {
  int i = 0;
  for (; i + kPacks * kLanes <= rows; i += kPacks * kLanes) {
    run_tile<Use, kPacks, Columns, false>(c + i, ldc, a + i, lda, b, k, t, Lanes(kLanes));
  }
  const int left = rows - i, packs = (left + kLanes - 1) / kLanes;
  const Lanes lanes(left - (packs - 1) * kLanes);
  static_assert(kPacks <= 3);
  if (packs == 1) run_tile<Use, 1, Columns, true>(c + i, ldc, a + i, lda, b, k, t, lanes);
  if (packs == 2) run_tile<Use, 2, Columns, true>(c + i, ldc, a + i, lda, b, k, t, lanes);
  if constexpr (kPacks == 3) {
    if (packs == 3) run_tile<Use, 3, Columns, true>(c + i, ldc, a + i, lda, b, k, t, lanes);
  }
}

/// run_strip for 1 … kStrip columns.
template <TileUse Use, int Most = kStrip>
inline void run_strip(int columns, double* c, int ldc, const double* a, int lda, Operand b, int rows, int k,
                      Triangle t = {}) {
  if (columns == Most) return run_strip<Use, Most>(c, ldc, a, lda, b, rows, k, t);
  if constexpr (Most > 1) run_strip<Use, Most - 1>(columns, c, ldc, a, lda, b, rows, k, t);
}

/// Width of the next strip of `left` columns: as few strips as can be, of about the same width.
inline int strip_width(int left) {
  const int strips = (left + kStrip - 1) / kStrip;
  return strips == 0 ? 0 : (left + strips - 1) / strips;
}

}  // namespace boxplus::dense::BOXPLUS_ISA
