// SPDX-License-Identifier: BSD-3-Clause
// A few doubles that are loaded, multiplied and stored together.
//
// The kernels are compiled once per instruction set, each time in a namespace of its own, BOXPLUS_ISA, and
// call nothing that is compiled elsewhere under the same name: else the linker might keep the copy of the
// wrong set.
#pragma once

#if defined(__AVX2__)
#include <immintrin.h>
#endif

#ifndef BOXPLUS_ISA
#define BOXPLUS_ISA baseline
#endif

namespace boxplus::dense::BOXPLUS_ISA {

// The vector extension of GCC and Clang; elsewhere one double, which the kernels accept as well.
// kPacks × kStrip is the largest tile that stays in the registers, with the operands of one step.
#if defined(__AVX512F__)
typedef double Pack __attribute__((vector_size(64)));
inline constexpr int kPacks = 3, kStrip = 8;
inline constexpr double kNanosecondsPerFlop = 0.025;
#elif defined(__AVX2__)
typedef double Pack __attribute__((vector_size(32)));
inline constexpr int kPacks = 2, kStrip = 6;
inline constexpr double kNanosecondsPerFlop = 0.03;
#elif defined(__GNUC__)
typedef double Pack __attribute__((vector_size(16)));
inline constexpr int kPacks = 2, kStrip = 4;
inline constexpr double kNanosecondsPerFlop = 0.08;
#else
using Pack = double;
inline constexpr int kPacks = 2, kStrip = 4;
inline constexpr double kNanosecondsPerFlop = 0.08;
#endif

inline constexpr int kLanes = static_cast<int>(sizeof(Pack) / sizeof(double));

inline Pack load(const double* from) {
  Pack pack;
  __builtin_memcpy(&pack, from, sizeof(Pack));
  return pack;
}

inline void store(double* to, Pack pack) {
  __builtin_memcpy(to, &pack, sizeof(Pack));
}

/// The first lanes of a pack: those beyond are neither read nor written.
class Lanes {
 public:
#if defined(__AVX512F__)
  explicit Lanes(int count) : mask_(static_cast<__mmask8>((1u << count) - 1)) {}
  Pack load(const double* from) const {
    return _mm512_maskz_loadu_pd(mask_, from);
  }
  void store(double* to, Pack pack) const {
    _mm512_mask_storeu_pd(to, mask_, pack);
  }

 private:
  __mmask8 mask_;
#elif defined(__AVX2__)
  explicit Lanes(int count) {
    constexpr long long kMask[] = {-1, -1, -1, -1, 0, 0, 0, 0};
    mask_ = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(kMask + 4 - count));
  }
  Pack load(const double* from) const {
    return _mm256_maskload_pd(from, mask_);
  }
  void store(double* to, Pack pack) const {
    _mm256_maskstore_pd(to, mask_, pack);
  }

 private:
  __m256i mask_;
#else
  explicit Lanes(int count) : count_(count) {}
  Pack load(const double* from) const {
    if (count_ == kLanes) return dense::BOXPLUS_ISA::load(from);
    const double lanes[kLanes] = {*from};  // two lanes at most
    return dense::BOXPLUS_ISA::load(lanes);
  }
  void store(double* to, Pack pack) const {
    if (count_ == kLanes) return dense::BOXPLUS_ISA::store(to, pack);
    __builtin_memcpy(to, &pack, sizeof(double));
  }

 private:
  int count_;
#endif
};

inline double sum(Pack pack) {
  double lanes[kLanes];
  __builtin_memcpy(lanes, &pack, sizeof(Pack));
  double total = lanes[0];
  for (int i = 1; i < kLanes; ++i) total += lanes[i];
  return total;
}

}  // namespace boxplus::dense::BOXPLUS_ISA
