// SPDX-License-Identifier: BSD-3-Clause
#include "plot/thinning.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>

namespace boxplus::app {
namespace {

using Cell = std::array<std::int64_t, 2>;

Cell cell_of(const Spot& spot, const Spot& origin, double pixel) {
  return {std::llround((spot[0] - origin[0]) / pixel), std::llround((spot[1] - origin[1]) / pixel)};
}

/// Joins consecutive steps of the trajectory until the joined step begins and ends in different pixels. The
/// segments must be in the order of time. Does not change the first step after a gap. If the last steps
/// before a gap or before the end stay within one pixel even when they are joined, they are left out.
std::vector<Segment> with_joined_steps(const std::vector<Segment>& segments, const Spot& origin,
                                       double pixel) {
  std::vector<Segment> result;
  std::optional<Spot> begin, end;  // the pending piece of the trajectory, which is still too short
  for (Segment segment : segments) {
    if (segment.kind == SegmentKind::kTrajectory) {
      const bool goes_on = end == segment.from;
      end = segment.to;
      if (goes_on) segment.from = *begin;
      begin = segment.from;
      if (goes_on && cell_of(segment.from, origin, pixel) == cell_of(segment.to, origin, pixel)) continue;
      begin = segment.to;
    }
    result.push_back(segment);
  }
  return result;
}

/// Keeps one item of each group of items that look the same. There is one key per item: a tuple whose first
/// element is equal for all items of a group, and whose last element is the index of the item. The item with
/// the smallest key of its group is kept.
template <class T, class Keys>
std::vector<T> without_copies(const std::vector<T>& items, Keys keys) {
  std::sort(keys.begin(), keys.end());
  const auto same = [](const auto& a, const auto& b) { return std::get<0>(a) == std::get<0>(b); };
  keys.erase(std::unique(keys.begin(), keys.end(), same), keys.end());
  std::vector<std::size_t> kept;
  for (const auto& key : keys) kept.push_back(std::get<std::size_t>(key));
  std::sort(kept.begin(), kept.end());
  std::vector<T> result;
  for (std::size_t index : kept) result.push_back(items[index]);
  return result;
}

std::vector<Segment> without_copies(const std::vector<Segment>& segments, const Spot& origin, double pixel) {
  using Look = std::tuple<SegmentKind, Cell, Cell>;
  std::vector<std::tuple<Look, double, std::size_t>> keys;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& segment = segments[i];
    const Cell a = cell_of(segment.from, origin, pixel), b = cell_of(segment.to, origin, pixel);
    const double badness = std::isnan(segment.chi2_per_row) ? HUGE_VAL : segment.chi2_per_row;
    keys.emplace_back(Look{segment.kind, std::min(a, b), std::max(a, b)}, -badness, i);
  }
  return without_copies(segments, std::move(keys));
}

std::vector<Spot> without_copies(const std::vector<Spot>& spots, const Spot& origin, double pixel) {
  std::vector<std::tuple<Cell, std::size_t>> keys;
  for (std::size_t i = 0; i < spots.size(); ++i) keys.emplace_back(cell_of(spots[i], origin, pixel), i);
  return without_copies(spots, std::move(keys));
}

std::vector<Dot> without_copies(const std::vector<Dot>& dots, const Spot& origin, double pixel) {
  std::vector<std::tuple<Cell, std::size_t>> keys;
  for (std::size_t i = 0; i < dots.size(); ++i) keys.emplace_back(cell_of(dots[i].spot, origin, pixel), i);
  return without_copies(dots, std::move(keys));
}

std::vector<SeenPoint> without_copies(const std::vector<SeenPoint>& points, const Spot& origin,
                                      double pixel) {
  std::vector<std::tuple<Cell, double, std::size_t>> keys;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double badness = std::isnan(points[i].chi2_per_row) ? HUGE_VAL : points[i].chi2_per_row;
    keys.emplace_back(cell_of(points[i].spot, origin, pixel), -badness, i);
  }
  return without_copies(points, std::move(keys));
}

}  // namespace

Scene thinned(Scene scene, double pixel, std::size_t most) {
  for (;; pixel *= 2) {
    scene.segments = without_copies(with_joined_steps(scene.segments, scene.low, pixel), scene.low, pixel);
    scene.landmarks = without_copies(scene.landmarks, scene.low, pixel);
    scene.dots = without_copies(scene.dots, scene.low, pixel);
    scene.scan_points = without_copies(scene.scan_points, scene.low, pixel);
    scene.points = without_copies(scene.points, scene.low, pixel);
    const std::size_t size = scene.segments.size() + scene.landmarks.size() + scene.dots.size() +
                             scene.scan_points.size() + scene.points.size();
    if (size <= most) return scene;
  }
}

}  // namespace boxplus::app
