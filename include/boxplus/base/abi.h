// SPDX-License-Identifier: BSD-3-Clause
// Makes sure that a client does not link if its Eigen aligns types differently than the library's Eigen.
//
// In each translation unit, the -m flags of the compiler determine the alignment of Eigen's fixed-size types
// and the allocator of its other types. So one struct may have two layouts in one program. The value types of
// boxplus do not depend on these flags, but users' types inside our templates may. Therefore, every public
// header references the symbol boxplus_abi_<version>_<EIGEN_MAX_ALIGN_BYTES>, and the library defines exactly
// one such symbol. The CMake target boxplus::boxplus sets EIGEN_MAX_ALIGN_BYTES=16, so that its users always
// match.
#pragma once

#include <Eigen/Core>

// The second macro calls the first, so that Eigen's macros are expanded before they are joined.
#define BOXPLUS_ABI_JOIN_1_(align) boxplus_abi_1_##align
#define BOXPLUS_ABI_JOIN_2_(align, static_align) boxplus_abi_1_##align##_static_##static_align
#define BOXPLUS_ABI_JOIN_1(align) BOXPLUS_ABI_JOIN_1_(align)
#define BOXPLUS_ABI_JOIN_2(align, static_align) BOXPLUS_ABI_JOIN_2_(align, static_align)
#if EIGEN_MAX_STATIC_ALIGN_BYTES == EIGEN_MAX_ALIGN_BYTES
#define BOXPLUS_ABI_SYMBOL BOXPLUS_ABI_JOIN_1(EIGEN_MAX_ALIGN_BYTES)
#else  // EIGEN_MAX_STATIC_ALIGN_BYTES differs from the alignment of Eigen's allocator.
#define BOXPLUS_ABI_SYMBOL BOXPLUS_ABI_JOIN_2(EIGEN_MAX_ALIGN_BYTES, EIGEN_MAX_STATIC_ALIGN_BYTES)
#endif

extern "C" const char BOXPLUS_ABI_SYMBOL;

// `used` stops the compiler from removing the reference, and `retain` stops the linker's --gc-sections from
// removing it.
#if __has_cpp_attribute(gnu::retain)
[[gnu::used, gnu::retain]]
#else
[[gnu::used]]
#endif
static const char* const boxplus_abi_reference = &BOXPLUS_ABI_SYMBOL;
