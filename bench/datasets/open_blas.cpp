// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/open_blas.h"

#include <cblas.h>
#include <dlfcn.h>
#include <omp.h>

#include <stdexcept>
#include <vector>

#include "base/stopwatch.h"

namespace boxplus::bench {
std::string library_of(const char* routine) {
  const void* address = dlsym(RTLD_DEFAULT, routine);
  Dl_info info;
  if (address == nullptr || dladdr(address, &info) == 0) return "no library";
  return info.dli_fname;
}

void require_open_blas_with_one_thread() {
  for (const char* routine : {"dgemm_", "dsyrk_", "dtrsm_", "dgemv_", "dtrsv_", "dpotrf_"}) {
    const std::string library = library_of(routine);
    if (library.find("openblas") == std::string::npos) {
      throw std::runtime_error(std::string(routine) + ": expected it in libopenblas, found it in " + library +
                               "; install libopenblas0-pthread");
    }
  }
  constexpr int kPthreads = 1;
  if (openblas_get_parallel() != kPthreads)
    throw std::runtime_error(
        "expected the pthread build of OpenBLAS, found another one; install libopenblas0-pthread");
  openblas_set_num_threads(1);
  if (openblas_get_num_threads() != 1 || omp_get_thread_limit() != 1) {
    throw std::runtime_error("expected OpenBLAS on one thread; set OMP_THREAD_LIMIT=1, as make bench does");
  }
}

std::string open_blas_version() {
  return std::string(openblas_get_config()) + ", kernels " + openblas_get_corename();
}

double dgemm_rate() {
  constexpr int n = 1024;
  const std::vector<double> a(n * n, 0.5), b(n * n, 0.25);
  std::vector<double> c(n * n);
  const Stopwatch clock;
  cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, n, n, n, 1, a.data(), n, b.data(), n, 0, c.data(),
              n);
  return 2e-9 * n * n * n / clock.seconds();
}

}  // namespace boxplus::bench
