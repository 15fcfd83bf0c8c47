// SPDX-License-Identifier: BSD-3-Clause
// Checks and measures the BLAS library that CHOLMOD and Ceres call. It must be OpenBLAS with one thread,
// because another BLAS would be slower, and the benchmarks compare single threads.
#pragma once

#include <string>

namespace boxplus::bench {

/// Returns the path of the shared library in which the dynamic linker finds `routine`, or "no library".
std::string library_of(const char* routine);

/// Limits OpenBLAS to one thread. Throws std::runtime_error if the BLAS and LAPACK routines that CHOLMOD
/// calls are not from OpenBLAS, or if OpenBLAS or OpenMP could still use more than one thread.
void require_open_blas_with_one_thread();

/// Returns the version, the build and the kernels of OpenBLAS.
std::string open_blas_version();

/// Multiplies two 1024 × 1024 matrices by DGEMM, and returns the GFLOP/s.
double dgemm_rate();

}  // namespace boxplus::bench
