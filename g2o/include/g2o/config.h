// SPDX-License-Identifier: BSD-3-Clause
// What every header of the g2o face includes first.
//
// Eigen derives the alignment of its fixed-size types from the -m flags of each translation unit, so that the
// classes that clients derive from could have two layouts in one program. Every header therefore references
// the symbol g2o_abi_1_<EIGEN_MAX_ALIGN_BYTES>, of which libg2o_core defines one: a mismatch is a link error
// that names it. The CMake targets set EIGEN_MAX_ALIGN_BYTES=16.
#pragma once

#include <Eigen/Core>

#if defined(_MSC_VER)
#define G2O_API_EXPORT
#else
#define G2O_API_EXPORT __attribute__((visibility("default")))
#endif

// LinearSolverCholmod and LinearSolverCSparse are always there.
#define G2O_HAVE_CHOLMOD 1
#define G2O_HAVE_CSPARSE 1

#define G2O_ABI_JOIN_(align) g2o_abi_1_##align
#define G2O_ABI_JOIN(align) G2O_ABI_JOIN_(align)
#define G2O_ABI_SYMBOL G2O_ABI_JOIN(EIGEN_MAX_ALIGN_BYTES)

extern "C" G2O_API_EXPORT const char G2O_ABI_SYMBOL;

#if defined(__has_cpp_attribute) && __has_cpp_attribute(gnu::retain)
[[gnu::used, gnu::retain]]
#else
[[gnu::used]]
#endif
static const char* const g2o_abi_reference = &G2O_ABI_SYMBOL;
