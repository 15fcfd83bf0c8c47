// SPDX-License-Identifier: BSD-3-Clause
#include "choose_points.h"

#include <cstddef>
#include <utility>

#include "base/disjoint_sets.h"
#include "divide_graph.h"

namespace boxplus::app {
namespace {

/// The observations of each point.
std::vector<std::uint32_t> degrees(const BalObservations& observations) {
  std::vector<std::uint32_t> degree(observations.points, 0);
  for (const std::uint64_t pair : observations.pairs) ++degree[pair >> 32];
  return degree;
}

/// Chooses points that connect cameras, and returns the connected components of the cameras. Points that only
/// `left_out` cameras see, or one other, connect nothing.
DisjointSets connect(const BalObservations& observations, const std::vector<bool>& left_out,
                     std::vector<bool>& chosen) {
  std::vector<bool> is_seen(observations.cameras, false);
  std::vector<std::uint32_t> first_camera(observations.points, observations.cameras);
  DisjointSets sets(observations.cameras);
  for (const std::uint64_t pair : observations.pairs) {
    const auto point = static_cast<std::uint32_t>(pair >> 32), camera = static_cast<std::uint32_t>(pair);
    if (left_out[camera]) continue;
    if (first_camera[point] == observations.cameras) first_camera[point] = camera;
    if (sets.join(first_camera[point], camera) || !is_seen[camera]) chosen[point] = true;
    is_seen[camera] = true;
  }
  return sets;
}

/// Enough points to see which cameras are connected, and how the others can move if the first camera of each
/// connected component is held: at most four per camera, and 50 more per component.
std::vector<bool> connecting_points(const BalObservations& observations,
                                    const std::vector<std::uint32_t>& degree) {
  constexpr int kOfFirst = 50;
  std::vector<bool> chosen(observations.points, false), is_first(observations.cameras, false);
  DisjointSets sets = connect(observations, is_first, chosen);
  std::vector<int> missing(observations.cameras, 0);  // points of this camera
  for (std::uint32_t camera = 0; camera < observations.cameras; ++camera) {
    is_first[camera] = sets.find(camera) == camera;
    if (is_first[camera]) missing[camera] = kOfFirst;
  }
  (void)connect(observations, is_first, chosen);
  for (const std::uint64_t pair : observations.pairs) {
    const auto point = static_cast<std::uint32_t>(pair >> 32), camera = static_cast<std::uint32_t>(pair);
    if (missing[camera] == 0 || degree[point] < 2) continue;
    --missing[camera];
    chosen[point] = true;
  }
  return chosen;
}

}  // namespace

PointChoice choose_points(BalObservations observations, std::uint32_t part, int parts) {
  const std::vector<std::uint32_t> degree = degrees(observations);
  PointChoice choice{std::vector<bool>(observations.points),
                     {.is_wanted = connecting_points(observations, degree)}};
  const std::vector<std::uint32_t> part_of =
      mpi::parts_of_eliminated(observations.pairs, observations.points, observations.cameras, parts);
  for (std::size_t point = 0; point < part_of.size(); ++point) {
    choice.own[point] = part_of[point] == part;
    if (choice.own[point]) choice.read.is_wanted[point] = true;
    if (choice.read.is_wanted[point]) choice.read.observations += degree[point];
  }
  return choice;
}

}  // namespace boxplus::app
