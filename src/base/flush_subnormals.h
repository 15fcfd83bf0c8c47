// SPDX-License-Identifier: BSD-3-Clause
// Arithmetic in which subnormal numbers are zero.
#pragma once

#include <cstdint>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace boxplus {

/// As long as this object exists, operands and results of this thread that are subnormal are zero, and so are
/// those of its parallel_tasks(). Processors are many times slower with them. They appear in
/// factors in float if robust kernels weight some edges by less than 1e-38.
class FlushSubnormals {
 public:
  FlushSubnormals() : before_(mode()) { set(before_ | kFlush); }
  ~FlushSubnormals() { set(before_); }
  FlushSubnormals(const FlushSubnormals&) = delete;
  FlushSubnormals& operator=(const FlushSubnormals&) = delete;

 private:
#if defined(__SSE2__)
  static constexpr unsigned kFlush = 0x8040;  // FTZ and DAZ of MXCSR
  static unsigned mode() {
    return _mm_getcsr();
  }
  static void set(unsigned mode) {
    _mm_setcsr(mode);
  }
  const unsigned before_;
#elif defined(__aarch64__)
  static constexpr std::uint64_t kFlush = std::uint64_t{1} << 24;  // FZ of FPCR
  static std::uint64_t mode() {
    std::uint64_t mode;
    __asm__ __volatile__("mrs %0, fpcr" : "=r"(mode));
    return mode;
  }
  static void set(std::uint64_t mode) {
    __asm__ __volatile__("msr fpcr, %0" : : "r"(mode));
  }
  const std::uint64_t before_;
#else
  static constexpr unsigned kFlush = 0;
  static unsigned mode() {
    return 0;
  }
  static void set(unsigned) {}
  const unsigned before_;
#endif
};

}  // namespace boxplus
