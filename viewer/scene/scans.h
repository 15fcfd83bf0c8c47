// SPDX-License-Identifier: BSD-3-Clause
// The points that lasers have hit, from the data of a file (boxplus/io/data.h).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "boxplus/io/graph_file.h"
#include "viewer/scene/structure.h"

namespace boxplus::viewer {

/// The scans of the poses of a structure. The points move with the poses, so they are in the frames of these.
struct Scans {
  std::vector<std::uint32_t> vertices;  ///< per scan: the number of its pose in the structure
  std::vector<std::uint32_t> counts;    ///< per scan: its number of points
  std::vector<float> points;            ///< x, y, z of each point, scan after scan, in meters

  bool empty() const { return vertices.empty(); }
};

/// All scans of a file, with the ids of their vertices.
class ScansOfFile {
 public:
  /// Reads the lines of data after vertices. Of more than kMostPoints points, keeps every nth one of all.
  /// Malformed lines are left out and noted. `name` is the name of the file.
  ScansOfFile(const GraphFile& file, const std::string& name);
  ScansOfFile() = default;

  /// The scans of the poses in the structure of `graph`. O(vertices + points).
  Scans of(const Graph& graph, const Structure& structure) const;
  /// What the user should know about the scans.
  const std::vector<std::string>& notes() const { return notes_; }

  static constexpr std::size_t kMostPoints = 1'000'000;

 private:
  struct Scan {
    Id vertex;
    std::size_t begin, end;  // of points_, in numbers
  };
  void thin();

  std::vector<Scan> scans_;
  std::vector<float> points_;
  std::vector<std::string> notes_;
};

}  // namespace boxplus::viewer
