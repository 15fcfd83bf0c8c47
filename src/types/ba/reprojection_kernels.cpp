// SPDX-License-Identifier: BSD-3-Clause
#include "types/ba/reprojection_kernels.h"

#include "kernels/kernel_table.h"

namespace boxplus::dense {

const Reproject* reprojection_kernels() {
#ifdef BOXPLUS_X86_KERNELS
  if (&kernels() == &avx512::kTable) return avx512::kReprojectionKernels;
  if (&kernels() == &avx2::kTable) return avx2::kReprojectionKernels;
#elif defined(BOXPLUS_ARM_KERNELS)
  if (&kernels() == &neon::kTable) return neon::kReprojectionKernels;
#endif
  return baseline::kReprojectionKernels;
}

}  // namespace boxplus::dense
