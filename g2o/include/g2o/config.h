// SPDX-License-Identifier: BSD-3-Clause
// Makes sure that a client and the g2o libraries are compiled with compatible settings. Every header of the
// g2o API includes this header first.
//
// Eigen derives the alignment of its fixed-size types from the -m flags of each translation unit. So the same
// class could have one layout in a client and another layout in a library. Other Eigen macros and the debug
// mode of the standard library cause the same problem. To detect the problem, this header references the
// symbol g2o_abi_1_<EIGEN_MAX_ALIGN_BYTES>, and the libraries define only g2o_abi_1_16. If the settings of a
// client differ, the client does not link. The name of the missing symbol also says which flag to add or
// remove. The CMake targets set EIGEN_MAX_ALIGN_BYTES=16. If a client with -mavx or -march=native does not
// set it, the compiler prints a note. This header does not set it for its file, because a file of the same
// client that uses Eigen without g2o would still have the other alignment, and the program could crash.
#pragma once
#ifndef G2O_CONFIG_H
#define G2O_CONFIG_H

#if (defined(_MSVC_LANG) ? _MSVC_LANG : __cplusplus) < 201402L
#error "the g2o API needs C++17: compile with -std=c++17, or set CMAKE_CXX_STANDARD to 17"
#include "the end of compilation"  // A missing file ends it. Otherwise, hundreds of other errors would follow.
#endif

#include <Eigen/Core>
#if EIGEN_MAX_ALIGN_BYTES > 16
#pragma message("Eigen's alignment differs from g2o's. Compile all files with -DEIGEN_MAX_ALIGN_BYTES=16.")
#endif
#include <iostream>  // clients rely on g2o's headers to include it
#include <iterator>

#if defined(_MSC_VER)
#define G2O_API_EXPORT
#else
#define G2O_API_EXPORT __attribute__((visibility("default")))
#endif

// LinearSolverCholmod and LinearSolverCSparse are always available, because they do not need these libraries.
#define G2O_HAVE_CHOLMOD 1
#define G2O_HAVE_CSPARSE 1

#if EIGEN_MAX_ALIGN_BYTES == 16
#define G2O_ABI_ALIGN
#elif defined(EIGEN_DONT_ALIGN)
#define G2O_ABI_ALIGN _remove_EIGEN_DONT_ALIGN
#else
#define G2O_ABI_ALIGN _add_EIGEN_MAX_ALIGN_BYTES_16
#endif
#if EIGEN_MAX_STATIC_ALIGN_BYTES == EIGEN_MAX_ALIGN_BYTES
#define G2O_ABI_STATIC
#else  // Eigen aligns fixed-size types and heap memory differently
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
