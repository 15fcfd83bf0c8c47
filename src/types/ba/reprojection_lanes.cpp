// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/ba/reprojection_lanes.h"

#include "types/ba/reprojection_kernels.h"

namespace boxplus::detail {
namespace {

template <class Camera>
dense::Reproject kernel_of() {
  const dense::ReprojectionKernels& kernels = dense::reprojection_kernels();
  if constexpr (std::is_same_v<Camera, BalCamera>) return kernels.bal;
  if constexpr (std::is_same_v<Camera, PinholeCamera>) return kernels.pinhole;
  if constexpr (std::is_same_v<Camera, SimpleRadialCamera>) return kernels.simple_radial;
}

}  // namespace

template <class Camera>
void linearize_reprojections(int count, const LaneSources<kReprojectionSources>& sources,
                             ReprojectionColumns columns, double* error, double* jacobian) {
  kernel_of<Camera>()({count, sources[0].data(), sources[1].data(), sources[2].data(), sources[3].data(),
                       columns.point, columns.camera},
                      error, jacobian);
}

template void linearize_reprojections<BalCamera>(int, const LaneSources<kReprojectionSources>&,
                                                 ReprojectionColumns, double*, double*);
template void linearize_reprojections<PinholeCamera>(int, const LaneSources<kReprojectionSources>&,
                                                     ReprojectionColumns, double*, double*);
template void linearize_reprojections<SimpleRadialCamera>(int, const LaneSources<kReprojectionSources>&,
                                                          ReprojectionColumns, double*, double*);

}  // namespace boxplus::detail
