// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/scene/scans.h"

#include <fmt/format.h>

#include <unordered_map>

#include "boxplus/base/error.h"
#include "boxplus/io/data.h"

namespace boxplus::viewer {
namespace {

using Points = std::vector<Vector<double, 2>>;

/// The points in the frame of the vertex; none if the data is no scan.
Points points_of(const Data& data) {
  if (const auto* laser = std::get_if<RobotLaser>(&data)) return laser->end_points_of_robot();
  if (const auto* laser = std::get_if<RawLaser>(&data)) return laser->end_points();
  return {};
}

/// The numbers of poses and cameras in the structure, by id.
std::unordered_map<Id, std::uint32_t> numbers_of_poses(const Graph& graph, const Structure& structure) {
  std::unordered_map<Id, std::uint32_t> numbers;
  for (const VertexGroup& group : structure.vertices) {
    if (group.first >= structure.oriented) break;
    const detail::VertexPool& pool = *graph.vertex_pools()[group.pool];
    std::uint32_t number = group.first;
    for (const std::uint32_t slot : group.slots)
      numbers.emplace(graph.id(VertexRef{group.pool, slot, pool.generation(slot)}), number++);
  }
  return numbers;
}

}  // namespace

ScansOfFile::ScansOfFile(const GraphFile& file, const std::string& name) {
  constexpr double kFarthest = 1e18;  // products of lengths must fit into a float
  constexpr std::size_t kMostNotes = 10;
  std::size_t malformed = 0;
  for (const GraphFile::KeptLine& line : file.kept) {
    if (line.place != GraphFile::KeptLine::Place::kAfterVertex) continue;
    try {
      const std::optional<Data> data = parse_data(line, name);
      if (!data) continue;
      const std::size_t begin = points_.size();
      for (const Vector<double, 2>& point : points_of(*data)) {
        if (point.cwiseAbs().maxCoeff() < kFarthest)
          points_.insert(points_.end(), {static_cast<float>(point[0]), static_cast<float>(point[1]), 0});
      }
      if (points_.size() > begin) scans_.push_back({line.after, begin, points_.size()});
    } catch (const InputError& error) {
      if (++malformed <= kMostNotes) notes_.push_back(fmt::format("not drawn: {}", error.what()));
    }
  }
  if (malformed > kMostNotes)
    notes_.push_back(fmt::format("… and {} more lines of data are not drawn", malformed - kMostNotes));
  thin();
}

void ScansOfFile::thin() {
  const std::size_t count = points_.size() / 3;
  if (count <= kMostPoints) return;
  const std::size_t step = (count + kMostPoints - 1) / kMostPoints;
  std::size_t kept = 0;
  for (Scan& scan : scans_) {
    const std::size_t begin = kept;
    for (std::size_t at = scan.begin; at < scan.end; at += 3) {
      if (at / 3 % step != 0) continue;
      for (std::size_t axis = 0; axis < 3; ++axis) points_[kept++] = points_[at + axis];
    }
    scan.begin = begin;
    scan.end = kept;
  }
  points_.resize(kept);
  notes_.push_back(fmt::format("{} of {} points of laser scans are drawn", kept / 3, count));
}

Scans ScansOfFile::of(const Graph& graph, const Structure& structure) const {
  Scans scans;
  if (scans_.empty()) return scans;
  const std::unordered_map<Id, std::uint32_t> numbers = numbers_of_poses(graph, structure);
  for (const Scan& scan : scans_) {
    const auto number = numbers.find(scan.vertex);
    if (number == numbers.end() || scan.begin == scan.end) continue;
    scans.vertices.push_back(number->second);
    scans.counts.push_back(static_cast<std::uint32_t>((scan.end - scan.begin) / 3));
    scans.points.insert(scans.points.end(), points_.begin() + static_cast<std::ptrdiff_t>(scan.begin),
                        points_.begin() + static_cast<std::ptrdiff_t>(scan.end));
  }
  return scans;
}

}  // namespace boxplus::viewer
