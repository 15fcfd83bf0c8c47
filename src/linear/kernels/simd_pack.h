// SPDX-License-Identifier: BSD-3-Clause
// A few doubles that are loaded, multiplied and stored together.
#pragma once

#include <cstring>

namespace boxplus::dense {

// The vector extension of GCC and Clang; elsewhere one double, which the kernels accept as well.
#if defined(__GNUC__)
typedef double Pair __attribute__((vector_size(16)));
#if defined(__AVX512F__)
typedef double Wide __attribute__((vector_size(64)));
#elif defined(__AVX__)
typedef double Wide __attribute__((vector_size(32)));
#else
using Wide = Pair;
#endif
#else
using Pair = double;
using Wide = double;
#endif

template <class Pack>
inline constexpr int kLanes = static_cast<int>(sizeof(Pack) / sizeof(double));

template <class Pack>
inline Pack load(const double* from) {
  Pack pack;
  std::memcpy(&pack, from, sizeof(Pack));
  return pack;
}

template <class Pack>
inline void store(double* to, Pack pack) {
  std::memcpy(to, &pack, sizeof(Pack));
}

template <class Pack>
inline double sum(Pack pack) {
  double lanes[kLanes<Pack>];
  std::memcpy(lanes, &pack, sizeof(Pack));
  double total = lanes[0];
  for (int i = 1; i < kLanes<Pack>; ++i) total += lanes[i];
  return total;
}

}  // namespace boxplus::dense
