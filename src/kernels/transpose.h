// SPDX-License-Identifier: BSD-3-Clause
// Transposes between two layouts: elements whose values are contiguous, and packs that contain one value of
// each of several elements.
#pragma once

#include "kernels/kernel_table.h"
#include "kernels/simd_pack.h"

namespace boxplus::dense::BOXPLUS_ISA {

/// Exchanges lane l of pack r and lane r of pack l, for all l and r.
inline void transpose(Pack (&p)[kLanes]) {
#if defined(__AVX512F__)
  constexpr __mmask8 kAll = 0xff;  // GCC warns that the forms without a mask use uninitialized values
  Pack pairs[8], quads[8];
#pragma GCC unroll 4
  for (int r = 0; r < 8; r += 2) {
    pairs[r] = _mm512_maskz_unpacklo_pd(kAll, p[r], p[r + 1]);
    pairs[r + 1] = _mm512_maskz_unpackhi_pd(kAll, p[r], p[r + 1]);
  }
  constexpr int kEven = 0x88, kOdd = 0xdd;  // select the 128-bit parts 0 2 0 2, and 1 3 1 3
#pragma GCC unroll 2
  for (int odd = 0; odd < 2; ++odd) {
    quads[odd] = _mm512_maskz_shuffle_f64x2(kAll, pairs[odd], pairs[odd + 2], kEven);
    quads[odd + 2] = _mm512_maskz_shuffle_f64x2(kAll, pairs[odd], pairs[odd + 2], kOdd);
    quads[odd + 4] = _mm512_maskz_shuffle_f64x2(kAll, pairs[odd + 4], pairs[odd + 6], kEven);
    quads[odd + 6] = _mm512_maskz_shuffle_f64x2(kAll, pairs[odd + 4], pairs[odd + 6], kOdd);
  }
#pragma GCC unroll 4
  for (int r = 0; r < 4; ++r) {
    p[r] = _mm512_maskz_shuffle_f64x2(kAll, quads[r], quads[r + 4], kEven);
    p[r + 4] = _mm512_maskz_shuffle_f64x2(kAll, quads[r], quads[r + 4], kOdd);
  }
#elif defined(__AVX2__)
  const Pack low0 = _mm256_unpacklo_pd(p[0], p[1]), high0 = _mm256_unpackhi_pd(p[0], p[1]);
  const Pack low1 = _mm256_unpacklo_pd(p[2], p[3]), high1 = _mm256_unpackhi_pd(p[2], p[3]);
  p[0] = _mm256_permute2f128_pd(low0, low1, 0x20);
  p[1] = _mm256_permute2f128_pd(high0, high1, 0x20);
  p[2] = _mm256_permute2f128_pd(low0, low1, 0x31);
  p[3] = _mm256_permute2f128_pd(high0, high1, 0x31);
#elif defined(__GNUC__) && __has_builtin(__builtin_shufflevector)
  static_assert(kLanes == 2);
  const Pack low = __builtin_shufflevector(p[0], p[1], 0, 2);
  p[1] = __builtin_shufflevector(p[0], p[1], 1, 3);
  p[0] = low;
#else
  for (int r = 0; r < kLanes; ++r) {
    for (int l = r + 1; l < kLanes; ++l) {
      double* a = reinterpret_cast<double*>(&p[r]) + l;
      double* b = reinterpret_cast<double*>(&p[l]) + r;
      const double t = *a;
      *a = *b;
      *b = t;
    }
  }
#endif
}

/// The offset of the first value of element k, if each element has a block of `size` values and the blocks
/// are stored in lanes.
inline long lane_offset(int size, int k) {
  return static_cast<long>(k / kTileLanes) * size * kTileLanes + k % kTileLanes;
}

/// packs[m] = value m of each element, for m = 0 … Count − 1. Reads no other values. With Count = 0, the
/// number is `count`.
template <int Count = 0>
[[gnu::always_inline]] inline void load_lanes(const double* const* elements, Pack* packs, int count = Count) {
  const auto load_part = [&](int m, auto here) __attribute__((always_inline)) {
    Pack rows[kLanes];
    if constexpr (here == kLanes) {
      for_each_index<kLanes>([&](auto l) { rows[l] = load(elements[l] + m); });
    } else {
      const Lanes some(here);
      for_each_index<kLanes>([&](auto l) { rows[l] = some.load(elements[l] + m); });
    }
    transpose(rows);
    for_each_index<here>([&](auto k) { packs[m + k] = rows[k]; });
  };
  const int size = Count > 0 ? Count : count;
  int m = 0;
#pragma GCC unroll 4
  for (; m + kLanes <= size; m += kLanes) load_part(m, std::integral_constant<int, kLanes>());
  for_each_index<kLanes / 2>([&](auto more) {  // a rest that is worth a transpose
    constexpr int kHere = kLanes / 2 + more;
    if (kHere > kLanes / 2 && size - m == kHere) {
      load_part(m, std::integral_constant<int, kHere>());
      m += kHere;
    }
  });
  for (; m < size; ++m) {
    double lanes[kLanes];
    for_each_index<kLanes>([&](auto l) { lanes[l] = elements[l][m]; });
    packs[m] = load(lanes);
  }
}

}  // namespace boxplus::dense::BOXPLUS_ISA
