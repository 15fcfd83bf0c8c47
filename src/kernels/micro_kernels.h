// SPDX-License-Identifier: BSD-3-Clause
// Register tiles: parts of a matrix product, a few packs high and one strip of columns wide, that are
// accumulated over k in registers.
#pragma once

#include "kernels/simd_pack.h"

namespace boxplus::dense::BOXPLUS_ISA {

/// The factor B in the product A B or A Bᵀ. Its entry (k, column) is at data[k * step_k + column *
/// step_column].
template <class Scalar>
struct Operand {
  const Scalar* data;
  int step_k, step_column;
};

/// The operation that a tile performs: C −= A·B, C = −A·B, or C = (C − A·B) T⁻ᵀ. T is a lower triangle, and
/// the inverses of its diagonal entries are given.
enum class TileUse { kSubtract, kSet, kDivide };

template <class Scalar>
struct Triangle {
  const Scalar* data = nullptr;
  int ld = 0;
  const Scalar* inverse_diagonal = nullptr;
};

/// Computes one tile of Packs packs of rows and Columns columns. If IsTail is true, only the first lanes of
/// the last pack, given by `lanes`, are used.
template <TileUse Use, int Packs, int Columns, bool IsTail, class Scalar>
inline void run_tile(Scalar* __restrict c, int ldc, const Scalar* a, int lda, Operand<Scalar> b, int k,
                     Triangle<Scalar> t, LanesOf<Scalar> lanes) {
  constexpr int kWidth = kLanesOf<Scalar>;
  const auto load_pack = [&](const Scalar* from, int p) {
    return IsTail && p == Packs - 1 ? lanes.load(from + p * kWidth) : load(from + p * kWidth);
  };
  PackOf<Scalar> tile[Columns][Packs];
#pragma GCC unroll 8
  for (int j = 0; j < Columns; ++j) {
#pragma GCC unroll 8
    for (int p = 0; p < Packs; ++p) {
      tile[j][p] = Use == TileUse::kSet ? PackOf<Scalar>{} : load_pack(c + static_cast<long>(j) * ldc, p);
    }
  }
  for (int i = 0; i < k; ++i) {
    PackOf<Scalar> column[Packs];
#pragma GCC unroll 8
    for (int p = 0; p < Packs; ++p) column[p] = load_pack(a, p);
#pragma GCC unroll 8
    for (int j = 0; j < Columns; ++j) {
      const Scalar factor = b.data[j * b.step_column];
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
    Scalar* to = c + static_cast<long>(j) * ldc;
#pragma GCC unroll 8
    for (int p = 0; p < Packs; ++p) {
      if (IsTail && p == Packs - 1) {
        lanes.store(to + p * kWidth, tile[j][p]);
      } else {
        store(to + p * kWidth, tile[j][p]);
      }
    }
  }
}

/// Computes a column of tiles, which covers all `rows` rows and `Columns` columns of C.
template <TileUse Use, int Columns, class Scalar>
void run_strip(Scalar* c, int ldc, const Scalar* a, int lda, Operand<Scalar> b, int rows, int k,
               Triangle<Scalar> t) {
  constexpr int kWidth = kLanesOf<Scalar>;
  int i = 0;
  for (; i + kPacks * kWidth <= rows; i += kPacks * kWidth) {
    run_tile<Use, kPacks, Columns, false>(c + i, ldc, a + i, lda, b, k, t, LanesOf<Scalar>(kWidth));
  }
  const int left = rows - i, packs = (left + kWidth - 1) / kWidth;
  const LanesOf<Scalar> lanes(left - (packs - 1) * kWidth);
  static_assert(kPacks <= 3);
  if (packs == 1) run_tile<Use, 1, Columns, true>(c + i, ldc, a + i, lda, b, k, t, lanes);
  if (packs == 2) run_tile<Use, 2, Columns, true>(c + i, ldc, a + i, lda, b, k, t, lanes);
  if constexpr (kPacks == 3) {
    if (packs == 3) run_tile<Use, 3, Columns, true>(c + i, ldc, a + i, lda, b, k, t, lanes);
  }
}

/// run_strip() for a number of columns, 1 … kStrip, that is known only at run time.
template <TileUse Use, int Most = kStrip, class Scalar>
inline void run_strip(int columns, Scalar* c, int ldc, const Scalar* a, int lda, Operand<Scalar> b, int rows,
                      int k, Triangle<Scalar> t = {}) {
  if (columns == Most) return run_strip<Use, Most>(c, ldc, a, lda, b, rows, k, t);
  if constexpr (Most > 1) run_strip<Use, Most - 1>(columns, c, ldc, a, lda, b, rows, k, t);
}

/// The width of the next strip if `left` columns remain. Divides them into as few strips as possible, all of
/// about the same width.
inline int strip_width(int left) {
  const int strips = (left + kStrip - 1) / kStrip;
  return strips == 0 ? 0 : (left + strips - 1) / strips;
}

}  // namespace boxplus::dense::BOXPLUS_ISA
