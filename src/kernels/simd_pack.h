// SPDX-License-Identifier: BSD-3-Clause
// Packs: a few values, double or float, that are loaded, multiplied and stored together.
//
// The kernels are compiled once per instruction set, each time in a different namespace, BOXPLUS_ISA. A
// kernel must not call an inline function outside of this namespace: all instruction sets would compile the
// function under the same name, and the linker would keep only one copy, possibly the copy for the wrong
// instruction set.
#pragma once

#include <utility>

#if defined(__AVX2__)
#include <immintrin.h>
#elif defined(BOXPLUS_NEON)
#include <arm_neon.h>
#endif

#ifndef BOXPLUS_ISA
#define BOXPLUS_ISA baseline
#endif

namespace boxplus::dense::BOXPLUS_ISA {

/// Calls f(std::integral_constant<int, 0>()) … with all i < N. The indices are constants before the compiler
/// decides what to keep in registers; after `#pragma GCC unroll`, this is too late for arrays.
template <int N, class F>
[[gnu::always_inline]] inline void for_each_index(F&& f) {
  [&]<int... I>(std::integer_sequence<int, I...>) {
    (f(std::integral_constant<int, I>()), ...);
  }
  (std::make_integer_sequence<int, N>());
}

// A pack uses the vector extension of GCC and Clang. For other compilers, a pack is a single scalar. kPacks ×
// kStrip is the largest tile that fits into the registers together with the operands of one step.
#if defined(__AVX512F__)
#define BOXPLUS_PACK_BYTES 64
inline constexpr int kPacks = 3, kStrip = 8;
inline constexpr double kNanosecondsPerFlop = 0.025;
#elif defined(__AVX2__)
#define BOXPLUS_PACK_BYTES 32
inline constexpr int kPacks = 2, kStrip = 6;
inline constexpr double kNanosecondsPerFlop = 0.03;
#elif defined(BOXPLUS_NEON)  // isa_neon.cpp; every compiler for 64-bit ARM may use NEON
#define BOXPLUS_PACK_BYTES 16
inline constexpr int kPacks = 3, kStrip = 8;
inline constexpr double kNanosecondsPerFlop = 0.07;
#elif defined(__GNUC__)
#define BOXPLUS_PACK_BYTES 16
inline constexpr int kPacks = 2, kStrip = 4;
inline constexpr double kNanosecondsPerFlop = 0.08;
#else
inline constexpr int kPacks = 2, kStrip = 4;
inline constexpr double kNanosecondsPerFlop = 0.08;
#endif

#ifdef BOXPLUS_PACK_BYTES
template <class Scalar>
struct PackType;
template <>
struct PackType<double> {
  typedef double Type __attribute__((vector_size(BOXPLUS_PACK_BYTES)));
};
template <>
struct PackType<float> {
  typedef float Type __attribute__((vector_size(BOXPLUS_PACK_BYTES)));
};
#undef BOXPLUS_PACK_BYTES
#else
template <class Scalar>
struct PackType {
  using Type = Scalar;
};
#endif

template <class Scalar>
using PackOf = typename PackType<Scalar>::Type;
template <class Scalar>
inline constexpr int kLanesOf = static_cast<int>(sizeof(PackOf<Scalar>) / sizeof(Scalar));

/// A pack of doubles.
using Pack = PackOf<double>;
inline constexpr int kLanes = kLanesOf<double>;

template <class Scalar>
inline PackOf<Scalar> load(const Scalar* from) {
  PackOf<Scalar> pack;
  __builtin_memcpy(&pack, from, sizeof(pack));
  return pack;
}

inline void store(double* to, PackOf<double> pack) {
  __builtin_memcpy(to, &pack, sizeof(pack));
}
inline void store(float* to, PackOf<float> pack) {
  __builtin_memcpy(to, &pack, sizeof(pack));
}

/// Loads and stores the first `count` lanes of a pack. The memory of the other lanes is neither read nor
/// written.
template <class Scalar>
class LanesOf {
 public:
#if defined(__AVX512F__)
  explicit LanesOf(int count) : mask_((1u << count) - 1) {}
  PackOf<Scalar> load(const Scalar* from) const {
    if constexpr (sizeof(Scalar) == sizeof(double)) {
      return _mm512_maskz_loadu_pd(static_cast<__mmask8>(mask_), from);
    } else {
      return _mm512_maskz_loadu_ps(static_cast<__mmask16>(mask_), from);
    }
  }
  void store(Scalar* to, PackOf<Scalar> pack) const {
    if constexpr (sizeof(Scalar) == sizeof(double)) {
      _mm512_mask_storeu_pd(to, static_cast<__mmask8>(mask_), pack);
    } else {
      _mm512_mask_storeu_ps(to, static_cast<__mmask16>(mask_), pack);
    }
  }

 private:
  unsigned mask_;
#elif defined(__AVX2__)
  explicit LanesOf(int count) {
    constexpr int kMask[] = {-1, -1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 0, 0};
    constexpr int kWords = static_cast<int>(sizeof(Scalar) / sizeof(int));
    mask_ = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(kMask + 8 - count * kWords));
  }
  PackOf<Scalar> load(const Scalar* from) const {
    if constexpr (sizeof(Scalar) == sizeof(double)) {
      return _mm256_maskload_pd(from, mask_);
    } else {
      return _mm256_maskload_ps(from, mask_);
    }
  }
  void store(Scalar* to, PackOf<Scalar> pack) const {
    if constexpr (sizeof(Scalar) == sizeof(double)) {
      _mm256_maskstore_pd(to, mask_, pack);
    } else {
      _mm256_maskstore_ps(to, mask_, pack);
    }
  }

 private:
  __m256i mask_;
#elif defined(BOXPLUS_NEON)
  explicit LanesOf(int count) : count_(count) {}
  PackOf<Scalar> load(const Scalar* from) const {
    if (count_ == kLanesOf<Scalar>) return dense::BOXPLUS_ISA::load(from);
    PackOf<Scalar> pack{from[0]};
    if constexpr (kLanesOf<Scalar> == 4) {
      if (count_ > 1) pack[1] = from[1];
      if (count_ > 2) pack[2] = from[2];
    }
    return pack;
  }
  void store(Scalar* to, PackOf<Scalar> pack) const {
    if (count_ == kLanesOf<Scalar>) return dense::BOXPLUS_ISA::store(to, pack);
    to[0] = pack[0];
    if constexpr (kLanesOf<Scalar> == 4) {
      if (count_ > 1) to[1] = pack[1];
      if (count_ > 2) to[2] = pack[2];
    }
  }

 private:
  int count_;
#else
  explicit LanesOf(int count) : count_(count) {}
  PackOf<Scalar> load(const Scalar* from) const {
    if (count_ == kLanesOf<Scalar>) return dense::BOXPLUS_ISA::load(from);
    Scalar lanes[kLanesOf<Scalar>] = {};
    for (int i = 0; i < count_; ++i) lanes[i] = from[i];
    return dense::BOXPLUS_ISA::load(lanes);
  }
  void store(Scalar* to, PackOf<Scalar> pack) const {
    if (count_ == kLanesOf<Scalar>) return dense::BOXPLUS_ISA::store(to, pack);
    Scalar lanes[kLanesOf<Scalar>];
    dense::BOXPLUS_ISA::store(lanes, pack);
    for (int i = 0; i < count_; ++i) to[i] = lanes[i];
  }

 private:
  int count_;
#endif
};

using Lanes = LanesOf<double>;

template <class Scalar>
inline Scalar sum_of(PackOf<Scalar> pack) {
  Scalar lanes[kLanesOf<Scalar>];
  __builtin_memcpy(lanes, &pack, sizeof(pack));
  Scalar total = lanes[0];
  for (int i = 1; i < kLanesOf<Scalar>; ++i) total += lanes[i];
  return total;
}

}  // namespace boxplus::dense::BOXPLUS_ISA
