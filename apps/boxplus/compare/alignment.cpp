// SPDX-License-Identifier: BSD-3-Clause
#include "compare/alignment.h"

#include <cmath>

#include "base/align_points.h"
#include "boxplus/base/error.h"

namespace boxplus::app {
namespace {

using Poses = std::vector<TrajectoryPose>;

std::vector<PosePair> matched_by_id(const Poses& result, const Poses& truth) {
  std::vector<PosePair> pairs;
  auto next = result.begin();
  for (const TrajectoryPose& pose : truth) {
    while (next != result.end() && next->id < pose.id) ++next;
    if (next != result.end() && next->id == pose.id) pairs.push_back({*next, pose});
  }
  return pairs;
}

/// Returns the index of the pose that is nearest to `time`; the earlier one if two poses are equally near.
/// The search begins at index `from`. `poses` must not be empty.
std::size_t nearest(const Poses& poses, double time, std::size_t from) {
  while (from + 1 < poses.size() && std::abs(poses[from + 1].time - time) < std::abs(poses[from].time - time))
    ++from;
  return from;
}

std::vector<PosePair> matched_by_time(const Poses& result, const Poses& truth, double most_seconds) {
  std::vector<PosePair> pairs;
  if (result.empty() || truth.empty()) return pairs;
  std::size_t i = 0, back = 0;
  for (std::size_t k = 0; k < truth.size(); ++k) {
    i = nearest(result, truth[k].time, i);
    back = nearest(truth, result[i].time, back);
    if (back == k && std::abs(result[i].time - truth[k].time) <= most_seconds)
      pairs.push_back({result[i], truth[k]});
  }
  return pairs;
}

Alignment umeyama(const std::vector<PosePair>& pairs, int dimension, bool with_scale) {
  Eigen::MatrixXd result(dimension, pairs.size()), truth(dimension, pairs.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    result.col(static_cast<Eigen::Index>(k)) = pairs[k].result.position.head(dimension);
    truth.col(static_cast<Eigen::Index>(k)) = pairs[k].truth.position.head(dimension);
  }
  if (with_scale && (result.colwise() - result.col(0)).isZero(0))
    throw InvalidArgument("--scale: expected poses at different positions, got all poses at one position");
  const PointAlignment aligned = align_points(result, truth, with_scale);
  Alignment alignment;
  alignment.scale = aligned.scale;
  if (!(alignment.scale > 0)) throw InvalidArgument("--scale: no scale above 0 fits the truth");
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

std::vector<PosePair> matched(const Trajectory& result, const Trajectory& truth, double most_seconds) {
  if (result.is_timed != truth.is_timed)
    throw InvalidArgument(
        "expected two graphs or two TUM files, got one of each; poses with ids cannot be matched with poses "
        "with times");
  if (result.dimension != truth.dimension)
    throw InvalidArgument("expected two graphs in the plane or two in space, got one of each");
  return truth.is_timed ? matched_by_time(result.poses, truth.poses, most_seconds)
                        : matched_by_id(result.poses, truth.poses);
}

Alignment align(const std::vector<PosePair>& pairs, int dimension, AlignmentKind kind, bool with_scale) {
  switch (kind) {
    case AlignmentKind::kRigid:
      return umeyama(pairs, dimension, with_scale);
    case AlignmentKind::kFirst:
      return from_first(pairs.front());
    default:
      return {};
  }
}

}  // namespace boxplus::app
