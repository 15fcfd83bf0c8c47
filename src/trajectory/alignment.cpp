// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/alignment.h"

#include <cmath>

#include "base/align_points.h"
#include "boxplus/base/error.h"

namespace boxplus {
namespace {

Alignment umeyama(const std::vector<PosePair>& pairs, int dimension, bool with_scale) {
  Eigen::MatrixXd result(dimension, pairs.size()), truth(dimension, pairs.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    result.col(static_cast<Eigen::Index>(k)) = pairs[k].result.position.head(dimension);
    truth.col(static_cast<Eigen::Index>(k)) = pairs[k].truth.position.head(dimension);
  }
  if (with_scale && (result.colwise() - result.col(0)).isZero(0))
    throw InvalidArgument(
        "expected poses at different positions to estimate a scale, got all poses at one position");
  const PointAlignment aligned = align_points(result, truth, with_scale);
  Alignment alignment;
  alignment.scale = aligned.scale;
  if (!(alignment.scale > 0)) throw InvalidArgument("no scale above 0 fits the truth");
  alignment.rotation.topLeftCorner(dimension, dimension) = aligned.rotation;
  alignment.translation.head(dimension) = aligned.translation;
  return alignment;
}

Alignment from_first(const PosePair& first) {
  Alignment alignment;
  alignment.rotation = first.truth.rotation * first.result.rotation.transpose();
  alignment.translation = first.truth.position - alignment.rotation * first.result.position;
  return alignment;
}

}  // namespace

TrajectoryPose Alignment::operator()(TrajectoryPose pose) const {
  pose.position = scale * (rotation * pose.position) + translation;
  pose.rotation = rotation * pose.rotation;
  return pose;
}

Alignment Alignment::inverse() const {
  Alignment back;
  back.scale = 1 / scale;
  back.rotation = rotation.transpose();
  back.translation = -back.scale * (back.rotation * translation);
  return back;
}

Alignment align_poses(const std::vector<PosePair>& pairs, int dimension, AlignmentKind kind,
                      bool with_scale) {
  switch (kind) {
    case AlignmentKind::kRigid:
      return umeyama(pairs, dimension, with_scale);
    case AlignmentKind::kFirst:
      return from_first(pairs.front());
    default:
      return {};
  }
}

}  // namespace boxplus
