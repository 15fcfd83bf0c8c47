// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/matching.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "boxplus/base/error.h"
#include "io/printable.h"

namespace boxplus {
namespace {

using Poses = std::vector<TrajectoryPose>;
using Source = TrajectorySource;

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

using PosesByName = std::unordered_map<std::string_view, const TrajectoryPose*>;

PosesByName by_name(const Poses& images) {
  PosesByName result;
  for (const TrajectoryPose& image : images) {
    const auto [other, is_new] = result.try_emplace(image.name, &image);
    if (!is_new) {
      throw InvalidArgument(
          fmt::format("images are matched by name: expected different names in each COLMAP model, but images "
                      "{} and {} are both named '{}'",
                      other->second->id, image.id, escaped(image.name)));
    }
  }
  return result;
}

std::vector<PosePair> matched_by_name(const Poses& result, const Poses& truth) {
  std::vector<PosePair> pairs;
  const PosesByName results = by_name(result), truths = by_name(truth);
  for (const TrajectoryPose& image : truth) {
    const auto same = results.find(image.name);
    if (same != results.end()) pairs.push_back({*same->second, image});
  }
  return pairs;
}

void require_equally_many(const Poses& a, const Poses& b) {
  if (a.size() == b.size()) return;
  throw InvalidArgument(
      fmt::format("the cameras of a BAL problem have no names, only positions: expected as many poses in the "
                  "other file, got {} and {}",
                  a.size(), b.size()));
}

/// The images whose names are the numbers of cameras, in the order of the cameras.
Poses named_like_cameras(const Poses& images) {
  std::unordered_map<std::string_view, const TrajectoryPose*> named;
  for (const TrajectoryPose& image : images) named[image.name] = &image;
  Poses result;
  for (std::size_t k = 0; k < images.size(); ++k) {
    const auto image = named.find(std::to_string(k));
    if (image != named.end()) result.push_back(*image->second);
  }
  return result;
}

/// The images in the order of their file, each of which must show as many points as the camera at the same
/// position.
Poses placed_like(const Poses& cameras, const Poses& images) {
  Poses result(images.size());
  for (const TrajectoryPose& image : images) result[image.position_in_file] = image;
  for (std::size_t k = 0; k < cameras.size(); ++k) {
    if (result[k].observations == cameras[k].observations) continue;
    throw InvalidArgument(fmt::format(
        "a BAL problem and a COLMAP model are matched by position: expected camera {} and image {} "
        "to show equally many points, got {} and {}",
        cameras[k].id, result[k].id, cameras[k].observations, result[k].observations));
  }
  return result;
}

/// The poses of a COLMAP model, in the order of the cameras of a BAL problem. Sets `matched_by`.
Poses ordered_like(const Poses& cameras, const Poses& images, const char*& matched_by) {
  require_equally_many(cameras, images);
  Poses result = named_like_cameras(images);
  const bool by_name = result.size() == images.size();
  matched_by = by_name ? "name" : "position";
  if (!by_name) result = placed_like(cameras, images);
  return result;
}

std::vector<PosePair> matched_by_order(const Poses& result, const Poses& truth) {
  std::vector<PosePair> pairs;
  for (std::size_t k = 0; k < result.size(); ++k) pairs.push_back({result[k], truth[k]});
  return pairs;
}

Poses with_colmap_axes(Poses cameras) {
  for (TrajectoryPose& camera : cameras) turn_to_colmap_axes(camera);
  return cameras;
}

}  // namespace

void turn_to_colmap_axes(TrajectoryPose& camera) {
  camera.rotation.rightCols<2>() *= -1;
}

PosePairs matched_poses(const Trajectory& result, const Trajectory& truth, double most_seconds) {
  if (result.is_timed() != truth.is_timed())
    throw InvalidArgument(
        "expected two graphs or two TUM files, got one of each; poses with ids cannot be matched with poses "
        "with times");
  if (result.dimension != truth.dimension)
    throw InvalidArgument("expected two graphs in the plane or two in space, got one of each");
  const auto are = [&](Source a, Source b) { return result.source == a && truth.source == b; };
  PosePairs pairs{{}, "id"};
  if (are(Source::kTum, Source::kTum)) {
    pairs = {matched_by_time(result.poses, truth.poses, most_seconds), "time"};
  } else if (are(Source::kColmap, Source::kColmap)) {
    pairs = {matched_by_name(result.poses, truth.poses), "name"};
  } else if (are(Source::kBal, Source::kBal)) {
    require_equally_many(result.poses, truth.poses);
    pairs = {matched_by_id(result.poses, truth.poses), "position"};
  } else if (are(Source::kBal, Source::kColmap)) {
    const Poses images = ordered_like(result.poses, truth.poses, pairs.matched_by);
    pairs.pairs = matched_by_order(with_colmap_axes(result.poses), images);
    pairs.turns_result = true;
  } else if (are(Source::kColmap, Source::kBal)) {
    const Poses images = ordered_like(truth.poses, result.poses, pairs.matched_by);
    pairs.pairs = matched_by_order(images, with_colmap_axes(truth.poses));
  } else {
    pairs.pairs = matched_by_id(result.poses, truth.poses);
  }
  return pairs;
}

}  // namespace boxplus
