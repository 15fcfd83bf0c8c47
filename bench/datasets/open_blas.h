// SPDX-License-Identifier: BSD-3-Clause
// The BLAS of the peers. It must be OpenBLAS with one thread; otherwise the figures are meaningless.
#pragma once

#include <string>

namespace boxplus::bench {

/// Returns the file of the library that provides `routine`, for calls from any library.
std::string library_of(const char* routine);

/// Throws std::runtime_error if the BLAS and LAPACK routines that CHOLMOD calls are not from OpenBLAS, or if
/// OpenBLAS or OpenMP may use more than one thread.
void require_open_blas_with_one_thread();

/// Returns the version, the build and the kernels of OpenBLAS.
std::string open_blas_version();

/// Returns the GFLOP/s of one DGEMM of 1024 × 1024 matrices.
double dgemm_rate();

}  // namespace boxplus::bench
