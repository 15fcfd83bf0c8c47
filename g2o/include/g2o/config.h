// SPDX-License-Identifier: BSD-3-Clause
// What every header of the g2o face includes first.
//
// Eigen derives the alignment of its fixed-size types from the -m flags of each translation unit, so that the
// classes that clients derive from could have two layouts in one program; so could other macros of Eigen's,
// and the debug mode of the standard library. Every header therefore references the symbol
// g2o_abi_1_<EIGEN_MAX_ALIGN_BYTES>. If a setting differs from the library's, the name also says which flag
// to add or to remove. The libraries define g2o_abi_1_16 alone, so that a mismatch is a link error which
// names the remedy. The CMake targets set EIGEN_MAX_ALIGN_BYTES=16.
#pragma once
#ifndef G2O_CONFIG_H
#define G2O_CONFIG_H

#include <Eigen/Core>
#include <iostream>  // g2o's headers bring it, and clients rely on that
#include <iterator>

#if defined(_MSC_VER)
#define G2O_API_EXPORT
#else
#define G2O_API_EXPORT __attribute__((visibility("default")))
#endif

// LinearSolverCholmod and LinearSolverCSparse are always there.
#define G2O_HAVE_CHOLMOD 1
#define G2O_HAVE_CSPARSE 1

#if EIGEN_MAX_ALIGN_BYTES == 16
#define G2O_ABI_ALIGN
#else
#define G2O_ABI_ALIGN _add_EIGEN_MAX_ALIGN_BYTES_16
#endif
#if EIGEN_MAX_STATIC_ALIGN_BYTES == EIGEN_MAX_ALIGN_BYTES
#define G2O_ABI_STATIC
#else  // fixed-size types align otherwise than what Eigen allocates
#define G2O_ABI_STATIC _remove_EIGEN_MAX_STATIC_ALIGN_BYTES
#endif
#if defined(EIGEN_DEFAULT_TO_ROW_MAJOR)
#define G2O_ABI_ORDER _remove_EIGEN_DEFAULT_TO_ROW_MAJOR
#else
#define G2O_ABI_ORDER
#endif
#if defined(_GLIBCXX_DEBUG)
#define G2O_ABI_CONTAINERS _remove_GLIBCXX_DEBUG
#else
#define G2O_ABI_CONTAINERS
#endif
#define G2O_ABI_JOIN_(align, align_remedy, static_remedy, order_remedy, containers_remedy) \
  g2o_abi_1_##align##align_remedy##static_remedy##order_remedy##containers_remedy
#define G2O_ABI_JOIN(align, align_remedy, static_remedy, order_remedy, containers_remedy) \
  G2O_ABI_JOIN_(align, align_remedy, static_remedy, order_remedy, containers_remedy)
#define G2O_ABI_SYMBOL \
  G2O_ABI_JOIN(EIGEN_MAX_ALIGN_BYTES, G2O_ABI_ALIGN, G2O_ABI_STATIC, G2O_ABI_ORDER, G2O_ABI_CONTAINERS)

extern "C" G2O_API_EXPORT const char G2O_ABI_SYMBOL;

#if defined(__has_cpp_attribute) && __has_cpp_attribute(gnu::retain)
[[gnu::used, gnu::retain]]
#else
[[gnu::used]]
#endif
static const char* const g2o_abi_reference = &G2O_ABI_SYMBOL;

#endif  // G2O_CONFIG_H
