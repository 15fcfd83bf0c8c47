// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/ba/reprojection_lanes.h"

#include "types/ba/reprojection_kernels.h"

namespace boxplus::detail {

void linearize_reprojections(int camera, int count, const LaneSources<kReprojectionSources>& sources,
                             ReprojectionColumns columns, double* error, double* jacobian) {
  dense::reprojection_kernels()[camera]({count, sources[0].data(), sources[1].data(), sources[2].data(),
                                         sources[3].data(), columns.point, columns.camera},
                                        error, jacobian);
}

}  // namespace boxplus::detail
