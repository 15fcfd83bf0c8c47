// SPDX-License-Identifier: BSD-3-Clause
// A client whose Eigen aligns differently from the library's does not link.
//
// Eigen derives the alignment of its fixed-size types from the -m flags of each translation unit, so the
// same struct may have two layouts in one program. boxplus' own value types never depend on it, but users'
// types inside our templates may. Every public header therefore references the symbol
// boxplus_abi_<version>_<EIGEN_MAX_ALIGN_BYTES>, of which the library defines exactly one. The CMake target
// boxplus::boxplus sets EIGEN_MAX_ALIGN_BYTES=16, so that users of the target never meet the mismatch.
#pragma once

#include <Eigen/Core>

#define BOXPLUS_ABI_JOIN_(version, align) boxplus_abi_##version##_##align
#define BOXPLUS_ABI_JOIN(version, align) BOXPLUS_ABI_JOIN_(version, align)
#define BOXPLUS_ABI_SYMBOL BOXPLUS_ABI_JOIN(1, EIGEN_MAX_ALIGN_BYTES)

extern "C" const char BOXPLUS_ABI_SYMBOL;

namespace {
[[gnu::used]] const char* const boxplus_abi_reference = &BOXPLUS_ABI_SYMBOL;
}
