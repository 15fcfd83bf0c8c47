// SPDX-License-Identifier: BSD-3-Clause
// The BLAS of the peers: it must be OpenBLAS with one thread, otherwise the figures are meaningless.
#pragma once

#include <string>

namespace boxplus::bench {

/// The file that contains `routine` for calls from any library.
std::string library_of(const char* routine);

/// Throws std::runtime_error if the BLAS and LAPACK routines that CHOLMOD calls are not OpenBLAS's, or if
/// OpenBLAS or OpenMP may use more than one thread.
void require_open_blas_with_one_thread();

/// Version, build and the kernels in use.
std::string open_blas_version();

/// GFLOP/s of one DGEMM of 1024 × 1024 matrices.
double dgemm_rate();

}  // namespace boxplus::bench
