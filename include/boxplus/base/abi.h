// SPDX-License-Identifier: BSD-3-Clause
// A client whose Eigen aligns differently from the library's does not link.
//
// Eigen derives the alignment of its fixed-size types, and the way it allocates the others, from the -m flags
// of each translation unit, so the same struct may have two layouts in one program. boxplus' own value types
// never depend on it, but users' types inside our templates may. Every public header therefore references the
// symbol boxplus_abi_<version>_<EIGEN_MAX_ALIGN_BYTES>, of which the library defines exactly one. The CMake
// target boxplus::boxplus sets EIGEN_MAX_ALIGN_BYTES=16, so that users of the target never meet the mismatch.
#pragma once

#include <Eigen/Core>

// Two steps, so that Eigen's macros are expanded before they are joined.
#define BOXPLUS_ABI_JOIN_1_(align) boxplus_abi_1_##align
#define BOXPLUS_ABI_JOIN_2_(align, static_align) boxplus_abi_1_##align##_static_##static_align
#define BOXPLUS_ABI_JOIN_1(align) BOXPLUS_ABI_JOIN_1_(align)
#define BOXPLUS_ABI_JOIN_2(align, static_align) BOXPLUS_ABI_JOIN_2_(align, static_align)
#if EIGEN_MAX_STATIC_ALIGN_BYTES == EIGEN_MAX_ALIGN_BYTES
#define BOXPLUS_ABI_SYMBOL BOXPLUS_ABI_JOIN_1(EIGEN_MAX_ALIGN_BYTES)
#else  // Eigen was asked for fixed-size types that align otherwise than its allocator.
#define BOXPLUS_ABI_SYMBOL BOXPLUS_ABI_JOIN_2(EIGEN_MAX_ALIGN_BYTES, EIGEN_MAX_STATIC_ALIGN_BYTES)
#endif

extern "C" const char BOXPLUS_ABI_SYMBOL;

// `used` keeps the reference through the optimiser, `retain` through the linker's --gc-sections.
#if __has_cpp_attribute(gnu::retain)
[[gnu::used, gnu::retain]]
#else
[[gnu::used]]
#endif
static const char* const boxplus_abi_reference = &BOXPLUS_ABI_SYMBOL;
